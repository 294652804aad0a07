#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace texbrdf::scene {

/// Where an object is: p_local = to_local · (p_parent − position). Distances in its frame, times `factor`, are at most
/// those in the parent's.
struct Frame {
  glm::dmat3 to_local{1};
  glm::dmat3 to_parent{1};  ///< without the position
  glm::dvec3 position{0};
  double factor = 1;

  glm::dvec3 local(const glm::dvec3& place) const { return to_local * (place - position); }
  glm::dvec3 parent(const glm::dvec3& place) const { return to_parent * place + position; }
};

/// Rz · Ry · Rx.
glm::dmat3 rotation_matrix(const Triple& radians);
Frame frame_of(const Transform& transform);

inline glm::dvec3 to_vector(const Triple& triple) {
  return {triple[0], triple[1], triple[2]};
}

}  // namespace texbrdf::scene
