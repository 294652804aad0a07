#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render/channel.h"
#include "render/geometry_table.h"
#include "render/shader_model.h"
#include "render/tone_map.h"

namespace texbrdf::render {

// What the render worker and its client say to each other. The worker greets first; then each request gets one answer.

enum class MessageKind : uint32_t {
  Greeting = 1,
  DrawRequest,
  EvaluateRequest,
  DrawAnswer,
  EvaluateAnswer,
  Refusal,
  SceneRequest,
  SceneAnswer
};

struct Greeting {
  bool has_renderer = false;
  std::string text;  ///< GL_RENDERER and GL_VERSION, or why there is no renderer
};

struct DrawRequest {
  ShaderModel model;
  SphereView view;
};

struct EvaluateRequest {
  ShaderModel model;
  GeometryTable geometry;
};

struct DrawAnswer {
  Picture picture;
  double milliseconds = 0;
  bool compiled = false;
};

struct EvaluateAnswer {
  std::vector<float> values;  ///< red, green, blue of each geometry
};

enum class RefusalKind : uint32_t { Request, Shader, Renderer };

/// Why a request has no answer.
struct Refusal {
  RefusalKind kind = RefusalKind::Request;
  std::string message;
};

Message encode(const Greeting& greeting);
Message encode(const DrawRequest& request);
Message encode(const EvaluateRequest& request);
Message encode(const DrawAnswer& answer);
Message encode(const EvaluateAnswer& answer);
Message encode(const Refusal& refusal);

/// Nothing where the message is of another kind or not well-formed: sizes that do not fit each other, values out of
/// range, bytes left over.
template <typename T>
std::optional<T> decode(const Message& message);

template <>
std::optional<Greeting> decode(const Message& message);
template <>
std::optional<DrawRequest> decode(const Message& message);
template <>
std::optional<EvaluateRequest> decode(const Message& message);
template <>
std::optional<DrawAnswer> decode(const Message& message);
template <>
std::optional<EvaluateAnswer> decode(const Message& message);
template <>
std::optional<Refusal> decode(const Message& message);

}  // namespace texbrdf::render
