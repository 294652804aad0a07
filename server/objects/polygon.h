#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace texbrdf::objects {

/// Twice the area of a polygon along its normal (M. Newell's method); near nothing where it has no area.
glm::dvec3 polygon_normal(std::span<const glm::dvec3> corners);

/// Whether all corners turn the same way, as seen along the normal.
bool is_convex(std::span<const glm::dvec3> corners, const glm::dvec3& normal);

/// Cuts a polygon of at least 3 corners into triangles of its corners, one less than two for each, that turn as it
/// does. Convex ones at once, others by their ears in a time that grows with the cube of their corners. One that
/// crosses itself is cut somehow.
std::vector<std::array<uint32_t, 3>> cut_polygon(std::span<const glm::dvec3> corners);

}  // namespace texbrdf::objects
