#pragma once

#include <memory>
#include <string>
#include <variant>

#include "render/egl_context.h"
#include "render/glsl_check.h"
#include "render/protocol.h"
#include "render/scene_protocol.h"

namespace texbrdf::render {

/// Answers requests with OpenGL: values of f in 32-bit floats, read back; the tone mapping is the one of the CPU.
class GpuRenderer {
 public:
  static Result<GpuRenderer> create(EglContext context, std::unique_ptr<const GlslChecker> checker);
  GpuRenderer(GpuRenderer&&) noexcept;
  GpuRenderer& operator=(GpuRenderer&&) noexcept;
  ~GpuRenderer();

  /// What draws: EglContext::description.
  const std::string& description() const;
  std::variant<DrawAnswer, Refusal> answer(const DrawRequest& request);
  std::variant<EvaluateAnswer, Refusal> answer(const EvaluateRequest& request);
  std::variant<SceneAnswer, Refusal> answer(const SceneRequest& request);

 private:
  struct State;
  explicit GpuRenderer(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace texbrdf::render
