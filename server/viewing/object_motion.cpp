#include "viewing/object_motion.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include "scene/frame.h"

namespace texbrdf::viewing {
namespace {

using glm::dmat3;
using glm::dvec3;
using scene::Triple;

/// An object further away is left where it is.
constexpr double kEdgeOfWorld = 1e6;

/// The angles of Rz · Ry · Rx. Where y is a right angle, x and z turn around the same axis: x is 0 then.
Triple angles_of(const dmat3& rotation) {
  constexpr double kAlmostRight = 1 - 1e-12;
  const double sine = std::clamp(-rotation[0][2], -1.0, 1.0);
  if (std::abs(sine) > kAlmostRight) return {0, std::asin(sine), std::atan2(-rotation[1][0], rotation[1][1])};
  return {std::atan2(rotation[1][2], rotation[2][2]), std::asin(sine), std::atan2(rotation[0][1], rotation[0][0])};
}

Triple turned(const Triple& angles, const dvec3& turn) {
  const dmat3 rotation(glm::rotate(glm::dmat4(1), glm::length(turn), glm::normalize(turn)));
  return angles_of(rotation * scene::rotation_matrix(angles));
}

Triple shifted(const Triple& position, const dvec3& step) {
  const dvec3 there = scene::to_vector(position) + step;
  const Triple result{there.x, there.y, there.z};
  const bool is_in_world = std::ranges::all_of(result, [](double x) { return std::abs(x) <= kEdgeOfWorld; });
  return is_in_world ? result : position;
}

}  // namespace

scene::Transform moved(const scene::Transform& from, const scene::Dynamic& dynamic, const HeldKeys& held,
                       double seconds) {
  dvec3 velocity(0);
  dvec3 turning(0);
  for (const scene::KeyBinding& binding : dynamic.keys) {
    if (!held.contains(binding.key)) continue;
    velocity += scene::to_vector(binding.velocity);
    turning += scene::to_vector(binding.turning);
  }
  scene::Transform result = from;
  if (velocity != dvec3(0)) result.position = shifted(from.position, velocity * seconds);
  const dvec3 turn = turning * seconds;
  const double angle = glm::length(turn);
  if (angle > 0 && std::isfinite(angle)) result.rotation = turned(from.rotation, turn);
  return result;
}

bool move_objects(scene::Scene& scene, const HeldKeys& held, double seconds) {
  bool has_moved = false;
  for (scene::Node& node : scene.nodes) {
    if (!node.dynamic) continue;
    const scene::Transform transform = moved(node.transform, *node.dynamic, held, seconds);
    has_moved = has_moved || transform != node.transform;
    node.transform = transform;
  }
  return has_moved;
}

bool binds(const scene::Scene& scene, std::string_view key) {
  return std::ranges::any_of(scene.nodes, [&](const scene::Node& node) {
    return node.dynamic && std::ranges::any_of(node.dynamic->keys,
                                               [&](const scene::KeyBinding& binding) { return binding.key == key; });
  });
}

}  // namespace texbrdf::viewing
