#include "viewing/camera_control.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec3.hpp>

#include "scene/frame.h"

namespace texbrdf::viewing {
namespace {

using glm::dvec3;
using scene::Camera;
using scene::Triple;

/// Of the line of sight from `up`, in radians.
constexpr double kLeastTilt = 0.02;
/// The sine of an angle that is taken for 0.
constexpr double kParallel = 1e-9;
constexpr double kNearest = 1e-3;
constexpr double kFarthest = 1e5;
/// Where single precision still tells neighbours apart.
constexpr double kEdgeOfWorld = 1e6;

Triple to_triple(const dvec3& vector) {
  return {vector.x, vector.y, vector.z};
}

/// Directions of the picture, of length 1.
struct Axes {
  dvec3 right;
  dvec3 up;
  dvec3 back;
};

Axes axes_of(const Camera& camera) {
  const dvec3 back = glm::normalize(scene::to_vector(camera.position) - scene::to_vector(camera.target));
  dvec3 right = glm::cross(glm::normalize(scene::to_vector(camera.up)), back);
  if (glm::length(right) < kParallel)
    right = glm::cross(std::abs(back.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 0, 1), back);
  right = glm::normalize(right);
  return {right, glm::cross(back, right), back};
}

/// Around an axis of length 1.
dvec3 turned(const dvec3& vector, const dvec3& axis, double radians) {
  return vector * std::cos(radians) + glm::cross(axis, vector) * std::sin(radians) +
         axis * (glm::dot(axis, vector) * (1 - std::cos(radians)));
}

bool is_in_world(const Camera& camera) {
  const auto is_near = [](double x) { return std::abs(x) <= kEdgeOfWorld; };
  return std::ranges::all_of(camera.position, is_near) && std::ranges::all_of(camera.target, is_near);
}

const Camera& valid_or(const Camera& changed, const Camera& camera) {
  return is_in_world(changed) ? changed : camera;
}

}  // namespace

Camera orbit(const Camera& camera, double right, double above) {
  const dvec3 pole = glm::normalize(scene::to_vector(camera.up));
  const dvec3 target = scene::to_vector(camera.target);
  const Axes axes = axes_of(camera);
  const double tilt = std::acos(std::clamp(glm::dot(axes.back, pole), -1.0, 1.0));
  const double wanted = std::clamp(tilt - above, kLeastTilt, glm::pi<double>() - kLeastTilt);
  const dvec3 raised = turned(scene::to_vector(camera.position) - target, axes.right, wanted - tilt);
  Camera changed = camera;
  changed.position = to_triple(target + turned(raised, pole, right));
  return valid_or(changed, camera);
}

Camera dolly(const Camera& camera, double notches) {
  const dvec3 target = scene::to_vector(camera.target);
  const dvec3 offset = scene::to_vector(camera.position) - target;
  const double distance = glm::length(offset);
  const double wanted = distance * std::pow(0.9, notches);
  Camera changed = camera;
  changed.position = to_triple(target + offset * (std::clamp(wanted, kNearest, kFarthest) / distance));
  return valid_or(changed, camera);
}

Camera walk(const Camera& camera, const Walk& direction, double seconds) {
  const dvec3 position = scene::to_vector(camera.position);
  const dvec3 target = scene::to_vector(camera.target);
  const Axes axes = axes_of(camera);
  const dvec3 along = axes.right * direction.right + axes.up * direction.up - axes.back * direction.forward;
  const dvec3 step = along * (glm::distance(position, target) * seconds);
  Camera changed = camera;
  changed.position = to_triple(position + step);
  changed.target = to_triple(target + step);
  return valid_or(changed, camera);
}

}  // namespace texbrdf::viewing
