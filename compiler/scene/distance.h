#pragma once

#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "scene/tree_plan.h"

namespace texbrdf::scene {

/// The distance function of a scene without a fault, in double: what its shader says. Primitives of users, which are
/// GLSL, are left out: no number of theirs is known here.
class Distances {
 public:
  explicit Distances(const Scene& scene, const PlanOptions& options = {}) : plan_(plan_tree(scene, options)) {}

  double at(const glm::dvec3& place) const { return of(plan_.root, place); }

 private:
  double of(uint32_t index, const glm::dvec3& place) const;
  double inside(const PlannedNode& node, const glm::dvec3& place) const;
  double united(const PlannedNode& node, const glm::dvec3& place) const;
  double joined(const PlannedNode& node, const glm::dvec3& place) const;
  double repeated(const PlannedNode& node, const glm::dvec3& place) const;

  TreePlan plan_;
};

}  // namespace texbrdf::scene
