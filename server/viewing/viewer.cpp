#include "viewing/viewer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "viewing/camera_control.h"

namespace texbrdf::viewing {
namespace {

/// A picture that took longer does not throw things out of sight.
constexpr double kLongestStep = 0.25;
/// Radians for a drag over the height of the picture.
constexpr double kTurn = std::numbers::pi;

struct WalkKey {
  std::string_view key;
  Walk walk;
};

constexpr std::array kWalkKeys{
    WalkKey{"W", {.forward = 1}},   WalkKey{"UP", {.forward = 1}},    WalkKey{"S", {.forward = -1}},
    WalkKey{"A", {.right = -1}},    WalkKey{"DOWN", {.forward = -1}}, WalkKey{"D", {.right = 1}},
    WalkKey{"LEFT", {.right = -1}}, WalkKey{"RIGHT", {.right = 1}},   WalkKey{"E", {.up = 1}},
    WalkKey{"PAGE_UP", {.up = 1}},  WalkKey{"Q", {.up = -1}},         WalkKey{"PAGE_DOWN", {.up = -1}}};

/// Two keys for one direction are no faster than one.
Walk walk_of(const HeldKeys& held) {
  Walk sum;
  for (const auto& [key, walk] : kWalkKeys) {
    if (!held.contains(key)) continue;
    sum.right += walk.right;
    sum.up += walk.up;
    sum.forward += walk.forward;
  }
  return {std::clamp(sum.right, -1.0, 1.0), std::clamp(sum.up, -1.0, 1.0), std::clamp(sum.forward, -1.0, 1.0)};
}

/// The keys that are the window's, and those that the scene binds.
struct Sides {
  HeldKeys window;
  HeldKeys scene;
};

bool holds_shift(const scene::Scene& scene, const HeldKeys& held) {
  return std::ranges::any_of(std::array{"LEFT_SHIFT", "RIGHT_SHIFT"},
                             [&](const char* shift) { return held.contains(shift) && !binds(scene, shift); });
}

Sides sides_of(const scene::Scene& scene, const HeldKeys& held) {
  if (holds_shift(scene, held)) return {held, {}};
  Sides sides;
  for (const std::string& key : held) (binds(scene, key) ? sides.scene : sides.window).insert(key);
  return sides;
}

double finite(double value) {
  return std::isfinite(value) ? value : 0;
}

scene::Camera moved_camera(const scene::Camera& camera, const Input& input, const Walk& direction, double seconds) {
  scene::Camera moved = camera;
  const double right = finite(input.drag_right);
  const double down = finite(input.drag_down);
  // The scene follows the pointer.
  if (right != 0 || down != 0) moved = orbit(moved, -kTurn * right, kTurn * down);
  if (const double notches = finite(input.wheel); notches != 0) moved = dolly(moved, notches);
  if (direction != Walk{}) moved = walk(moved, direction, seconds);
  return moved;
}

bool is_same(const scene::Camera& one, const scene::Camera& other) {
  return one.position == other.position && one.target == other.target && one.up == other.up &&
         one.field_of_view == other.field_of_view;
}

std::map<std::string_view, const scene::Transform*> places_of(const scene::Scene& scene) {
  std::map<std::string_view, const scene::Transform*> places;
  for (const scene::Node& node : scene.nodes) {
    if (node.dynamic) places[node.dynamic->name] = &node.transform;
  }
  return places;
}

}  // namespace

bool Viewer::press(std::string_view key) {
  if (key == "ESCAPE") wants_to_close_ = true;
  if (key == "R") return reset();
  const std::string_view digit = key.starts_with("KP_") ? key.substr(3) : key;
  if (digit.size() != 1 || digit[0] < '1' || digit[0] >= static_cast<char>('1' + kViewCount)) return false;
  const uint32_t before = std::exchange(view_, static_cast<uint32_t>(digit[0] - '1'));
  return before != view_;
}

bool Viewer::reset() {
  bool has_moved = false;
  for (std::size_t i = 0; i < scene_.nodes.size(); ++i) {
    const scene::Transform before = std::exchange(scene_.nodes[i].transform, loaded_.nodes[i].transform);
    has_moved = has_moved || before != scene_.nodes[i].transform;
  }
  const scene::Camera camera = std::exchange(scene_.camera, loaded_.camera);
  return has_moved || !is_same(camera, scene_.camera);
}

bool Viewer::apply(const Input& input) {
  const bool has_shift = holds_shift(scene_, input.held);
  bool is_other = false;
  for (const std::string& key : input.pressed) {
    const bool is_the_scenes = !has_shift && key != "ESCAPE" && binds(scene_, key);
    if (!is_the_scenes && press(key)) is_other = true;
  }
  const Sides sides = sides_of(scene_, input.held);
  const double seconds = std::clamp(finite(input.seconds), 0.0, kLongestStep);
  const scene::Camera camera =
      std::exchange(scene_.camera, moved_camera(scene_.camera, input, walk_of(sides.window), seconds));
  if (move_objects(scene_, sides.scene, seconds)) is_other = true;
  return is_other || !is_same(camera, scene_.camera);
}

void Viewer::reload(scene::Scene scene) {
  const auto as_loaded = places_of(loaded_);
  const auto present = places_of(scene_);
  scene::Scene changed = scene;
  for (scene::Node& node : changed.nodes) {
    if (!node.dynamic) continue;
    const auto before = as_loaded.find(node.dynamic->name);
    if (before != as_loaded.end() && *before->second == node.transform)
      node.transform = *present.at(node.dynamic->name);
  }
  if (is_same(changed.camera, loaded_.camera)) changed.camera = scene_.camera;
  loaded_ = std::move(scene);
  scene_ = std::move(changed);
}

}  // namespace texbrdf::viewing
