#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>

#include "scene/scene.h"
#include "scene/tree_plan.h"

namespace texbrdf::scene {

/// The distance function of a built-in primitive, in double.
double primitive_distance(ObjectKind kind, const glm::dvec3& place, const std::array<double, kMaxData>& data);

/// What the operations use, in double: the functions of the same names in distance_functions.def.
double length_above(const glm::dvec2& d);
double smooth_union(double a, double b, double k);
double smooth_intersection(double a, double b, double k);
glm::dvec3 first_copy(const Repetition& plan, const glm::dvec3& x);
double distance_beside(const Repetition& plan, const glm::dvec3& x, const glm::dvec3& first);
double guarded(double value, double outside, const Guard& guard);
double twisted_distance(double raw, double k, double radius);
double bent_distance(double raw, double k, double radius);
double box_distance(const glm::dvec3& place, const glm::dvec3& half_size);
glm::dvec2 turned(const glm::dvec2& place, double angle);
double displacement(const glm::dvec3& place, double amplitude, double frequency);

/// One divided by the spacing, 0 where that is 0.
glm::dvec3 inverse_spacing(const Repetition& plan);

/// The name of a built-in primitive's function in GLSL, and how many numbers it takes after the place.
struct PrimitiveFunction {
  std::string_view name;
  std::size_t number_count = 0;
};
PrimitiveFunction primitive_function(ObjectKind kind);

/// Those of all functions of distance_functions.def that `code` calls, and those that they call, as GLSL.
std::string functions_for(std::string_view code);

}  // namespace texbrdf::scene
