#include "scene/frame.h"

#include <algorithm>
#include <cmath>

namespace texbrdf::scene {
namespace {

/// Turns the axis `from` towards the axis `to`.
glm::dmat3 turn(int from, int to, double radians) {
  glm::dmat3 matrix(1);
  matrix[from][from] = matrix[to][to] = std::cos(radians);
  matrix[from][to] = std::sin(radians);
  matrix[to][from] = -std::sin(radians);
  return matrix;
}

glm::dmat3 diagonal(const glm::dvec3& values) {
  return {glm::dvec3(values.x, 0, 0), glm::dvec3(0, values.y, 0), glm::dvec3(0, 0, values.z)};
}

}  // namespace

glm::dmat3 rotation_matrix(const Triple& radians) {
  return turn(0, 1, radians[2]) * turn(2, 0, radians[1]) * turn(1, 2, radians[0]);
}

Frame frame_of(const Transform& transform) {
  const glm::dmat3 rotation = rotation_matrix(transform.rotation);
  const glm::dvec3 scale = to_vector(transform.scale);
  return {diagonal(1.0 / scale) * glm::transpose(rotation), rotation * diagonal(scale), to_vector(transform.position),
          std::min({std::abs(scale.x), std::abs(scale.y), std::abs(scale.z)})};
}

}  // namespace texbrdf::scene
