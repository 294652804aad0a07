#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace texbrdf::scene {

/// What of a scene a message is about, so that whoever read the scene can tell where it stands.
enum class Part : uint8_t {
  Scene,
  NodeKind,       ///< `index` is the node
  NodeData,       ///< `index` is the node, `item` the number
  NodeTransform,  ///< `index` is the node
  NodeMaterial,   ///< `index` is the node
  NodeChildren,   ///< `index` is the node
  NodeDynamic,    ///< `index` is the node
  UserPrimitive,  ///< `item` is the line of the code, counted from 0
  Shader,         ///< the same
  Property,       ///< `index` is the shader, `item` the property
  Material,
  MaterialValue,  ///< `index` is the material, `item` the property
  Camera,
  LightSource,
  Environment,
  Settings,
};

struct SceneFault {
  Part part = Part::Scene;
  uint32_t index = 0;
  uint32_t item = 0;
  std::string message;  ///< one line, without the place: "the radius must be more than 0, but is -1"
};

/// What a number must be, or nothing where it is: "more than 0".
std::string_view broken_rule(Domain domain, double value);

/// What keeps a scene from being drawn, or nothing. What has no fault can be evaluated, bounded and compiled, apart
/// from code of users that GLSL compilers reject.
std::optional<SceneFault> find_fault(const Scene& scene);

}  // namespace texbrdf::scene
