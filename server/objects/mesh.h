#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace texbrdf::objects {

/// A corner of triangles. `normal` is a unit vector; `tangent` is one at right angles to it, or zero where X follows
/// from N as on the sphere.
struct Vertex {
  glm::vec3 position;
  glm::vec3 normal;
  glm::vec3 tangent;
};

using Triangle = std::array<uint32_t, 3>;  ///< places in Mesh::vertices, counter-clockwise seen from outside

/// A surface of triangles; right-handed, +y is up. All numbers are finite, and vertices do not all lie in one place.
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
};

/// `wish` made a unit vector at right angles to the unit vector `normal`. Where `wish` has no such part: the sphere's
/// tangent (0,1,0) × N, and (1,0,0) where that is nothing either.
glm::dvec3 tangent_along(const glm::dvec3& normal, const glm::dvec3& wish);

/// Moves and scales the mesh into the unit sphere around the origin: the middle of its bounding box there, its farthest
/// vertex on the sphere.
void fit_into_unit_sphere(Mesh& mesh);

}  // namespace texbrdf::objects
