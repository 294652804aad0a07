#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "scene/frame.h"
#include "scene/scene.h"

namespace texbrdf::scene {

/// The distance function of a scene without a fault, in double. Primitives of users, which are GLSL, are left out: no
/// number of theirs is known here.
class Distances {
 public:
  /// The scene outlives the object.
  explicit Distances(const Scene& scene);

  double at(const glm::dvec3& place) const;
  /// In the frame of the object's parent.
  double of(NodeId node, const glm::dvec3& place) const;

 private:
  double inside(const Node& node, const glm::dvec3& place) const;
  double united(const Node& node, const glm::dvec3& place) const;
  double joined(const Node& node, const glm::dvec3& place) const;
  double repeated(const Node& node, const glm::dvec3& place) const;

  const Scene& scene_;
  std::vector<Frame> frames_;
};

}  // namespace texbrdf::scene
