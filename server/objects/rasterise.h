#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <vector>

#include "objects/mesh.h"

namespace texbrdf::objects {

/// From where an object is seen, in degrees: the object turned around +y (counter-clockwise seen from above), then its
/// top towards the viewer.
struct Orbit {
  double yaw = 0;
  double pitch = 0;
  friend bool operator==(const Orbit&, const Orbit&) = default;
};

/// From the object to the viewer, who looks along -z: +x is right, +y is up.
glm::dmat3 rotation_of(const Orbit& orbit);

/// What a ray of a pixel meets first: a place in a triangle, by the weights of its second and third corner.
struct Fragment {
  uint32_t triangle = 0;
  float second = 0;
  float third = 0;
};

/// The fragments of a square picture, pixel by pixel, row by row from the top left.
struct Coverage {
  uint32_t size = 0;             ///< pixels, width and height
  std::vector<uint8_t> alpha;    ///< of each pixel: what part of its rays meets something
  std::vector<uint32_t> begins;  ///< of each pixel: where its fragments begin; one more entry at the end
  std::vector<Fragment> fragments;
};

/// Rays in a pixel.
inline constexpr std::size_t kRays = 4;

/// The mesh seen without perspective along -z of `rotation` times it, a unit of it as many pixels as `scale`, its
/// origin in the middle. Both sides of a triangle are seen.
Coverage rasterise(const Mesh& mesh, const glm::dmat3& rotation, uint32_t size, double scale);

/// N, X and Y, orthonormal, as the viewer sees them: N is on the viewer's side.
struct SurfaceFrame {
  glm::dvec3 normal;
  glm::dvec3 tangent;
  glm::dvec3 bitangent;
};

/// An interpolated normal that is turned away from the viewer at a silhouette is bent until N·V is this.
inline constexpr double kLeastCosine = 0.01;

SurfaceFrame frame_at(const Mesh& mesh, const glm::dmat3& rotation, const Fragment& fragment);

/// The frame of a mere normal, X and Y as on the sphere: `normal` as the viewer sees it.
SurfaceFrame frame_of_normal(const glm::dmat3& rotation, const glm::dvec3& normal);

}  // namespace texbrdf::objects
