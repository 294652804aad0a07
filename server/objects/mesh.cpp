#include "objects/mesh.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace texbrdf::objects {

namespace {

/// What of a unit vector is left at right angles to another counts as a direction from here on.
constexpr double kLeastSine = 1e-6;

}  // namespace

glm::dvec3 tangent_along(const glm::dvec3& normal, const glm::dvec3& wish) {
  const double length = glm::length(wish);
  if (length > 0 && std::isfinite(length)) {
    const glm::dvec3 along = wish / length;
    const glm::dvec3 rest = along - normal * glm::dot(normal, along);
    if (glm::length(rest) > kLeastSine) return glm::normalize(rest);
  }
  const glm::dvec3 around = glm::cross(glm::dvec3(0, 1, 0), normal);
  if (glm::length(around) > kLeastSine) return glm::normalize(around);
  return glm::normalize(glm::dvec3(1, 0, 0) - normal * normal.x);
}

void fit_into_unit_sphere(Mesh& mesh) {
  glm::dvec3 low(mesh.vertices.front().position);
  glm::dvec3 high = low;
  for (const Vertex& vertex : mesh.vertices) {
    low = glm::min(low, glm::dvec3(vertex.position));
    high = glm::max(high, glm::dvec3(vertex.position));
  }
  const glm::dvec3 middle = low + (high - low) * 0.5;
  double radius = 0;
  for (const Vertex& vertex : mesh.vertices) {
    radius = std::max(radius, glm::length(glm::dvec3(vertex.position) - middle));
  }
  for (Vertex& vertex : mesh.vertices) vertex.position = glm::vec3((glm::dvec3(vertex.position) - middle) / radius);
}

}  // namespace texbrdf::objects
