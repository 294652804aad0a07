#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "scene/box.h"
#include "scene/frame.h"
#include "scene/scene.h"

namespace texbrdf::scene {

/// What stands for a node far from it: outside of the box, where the node says more than `level`, its value is taken to
/// be `level` more than the distance to the box. Within `margin` of the box it passes into the own one: min(max(value,
/// level + d), level + 2 margin − d), which has a slope of at most 1 and the same sign.
struct Guard {
  Box box;
  double level = 0;
  double margin = 0;
};

/// See repetition.h. Of an axis that is not repeated, `spacing` and `last` are 0.
struct Repetition {
  glm::dvec3 spacing{0};
  glm::dvec3 last{0};  ///< copies −last … last
  glm::dvec3 window{1};
  glm::dvec3 centre{0};  ///< of the box of the copy 0
  glm::dvec3 half{0};
  double level = 0;  ///< outside of the boxes the children say more than this
};

/// An object as it is evaluated, on the CPU and in shaders. The value of each has a slope of at most 1, if the
/// primitives of users keep theirs.
struct PlannedNode {
  ObjectKind kind = ObjectKind::Union;
  std::array<double, kMaxData> data{};
  NodeId node;  ///< not valid: a union that the scene does not have
  UserPrimitiveId user_primitive;
  std::optional<Triple> bounds;    ///< of a primitive of a user
  double lipschitz = 1;            ///< what its value is divided by: of a displacement, a primitive of a user
  uint32_t leaf = 0;               ///< a primitive's node, of an operation that of the first primitive below
  std::vector<uint32_t> children;  ///< indices, smaller than the own one
  Frame frame;
  std::optional<uint32_t> dynamic;  ///< its number among the dynamic objects

  /// Guards and repetition may replace values whose absolute value is larger, by ones of the same sign that are larger
  /// too; infinite: they may replace none. In the frame of the node, as all that follows.
  double level = 0;
  std::optional<Guard> guard;
  std::optional<Repetition> repetition;
  std::optional<Box> cut;  ///< of a twist or bend: nothing of it is outside, and far away the distance to this counts
};

/// All objects of a scene as one tree.
struct TreePlan {
  std::vector<PlannedNode> nodes;
  uint32_t root = 0;
};

struct PlanOptions {
  bool guards = true;  ///< skip what is far; the surfaces are the same without
};

bool is_primitive(ObjectKind kind);

/// The scene has no fault.
TreePlan plan_tree(const Scene& scene, const PlanOptions& options = {});

/// The material of each node: its own or that of its nearest ancestor that has one, else one more than the last.
std::vector<uint32_t> material_of_nodes(const Scene& scene);

}  // namespace texbrdf::scene
