#pragma once

#include <string>
#include <vector>

#include "render/protocol.h"
#include "render/scene_view.h"

namespace texbrdf::render {

/// One sample of each pixel of a tile. A picture is drawn tile by tile, so that each answer comes before the deadline.
struct SceneRequest {
  std::string source;  ///< scene::SceneShader::source
  SceneState state;
  SceneLook look;
  SceneTile tile;
  SceneSample sample;
};

struct SceneAnswer {
  std::vector<float> values;  ///< red, green, blue of each pixel, row by row from the top left; not finite: marked
  double milliseconds = 0;
  bool compiled = false;
};

Message encode(const SceneRequest& request);
Message encode(const SceneAnswer& answer);

template <>
std::optional<SceneRequest> decode(const Message& message);
template <>
std::optional<SceneAnswer> decode(const Message& message);

/// Why the request cannot be drawn, in words, or nothing.
std::optional<std::string> find_fault(const SceneRequest& request);

}  // namespace texbrdf::render
