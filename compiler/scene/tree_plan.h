#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/frame.h"
#include "scene/scene.h"

namespace texbrdf::scene {

/// An object as it is evaluated, on the CPU and in shaders.
struct PlannedNode {
  ObjectKind kind = ObjectKind::Union;
  std::array<double, kMaxData> data{};
  UserPrimitiveId user_primitive;
  uint32_t leaf = 0;               ///< the node of the scene that this is, of an operation the first primitive below
  std::vector<uint32_t> children;  ///< indices, smaller than the own one
  Frame frame;
  std::optional<uint32_t> dynamic;  ///< its number among the dynamic objects
};

/// All objects of a scene as one tree.
struct TreePlan {
  std::vector<PlannedNode> nodes;
  uint32_t root = 0;
};

bool is_primitive(ObjectKind kind);

/// The scene has no fault.
TreePlan plan_tree(const Scene& scene);

/// The material of each node: its own or that of its nearest ancestor that has one, else one more than the last.
std::vector<uint32_t> material_of_nodes(const Scene& scene);

}  // namespace texbrdf::scene
