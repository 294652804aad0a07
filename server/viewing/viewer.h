#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "viewing/object_motion.h"

namespace texbrdf::viewing {

/// Keys 1 to 5.
inline constexpr uint32_t kViewCount = 5;

/// What a person did since the picture before.
struct Input {
  HeldKeys held;                     ///< called as KeyBinding calls them
  double seconds = 0;                ///< for which they were
  std::vector<std::string> pressed;  ///< went down, in this order
  double drag_right = 0;             ///< of the pointer, in heights of the picture
  double drag_down = 0;
  double wheel = 0;  ///< notches, away from the person
};

/// What a person has made of a scene: where the camera is, where the objects are, which view is shown. A key that the
/// scene binds moves its object and nothing else, but Escape; while a Shift is held that the scene does not bind, keys
/// are those of the window.
class Viewer {
 public:
  /// Without a fault.
  explicit Viewer(scene::Scene scene) : loaded_(scene), scene_(std::move(scene)) {}

  /// With the camera and the objects where they are now.
  const scene::Scene& scene() const { return scene_; }
  /// Of the views that there are, from 0.
  uint32_t view() const { return view_; }
  void show_view(uint32_t view) { view_ = view; }
  bool wants_to_close() const { return wants_to_close_; }

  /// Whether the picture is another one now.
  bool apply(const Input& input);
  /// The files have changed. A camera, or an object of a name, that the files do not move stays where it is now.
  void reload(scene::Scene scene);

 private:
  bool press(std::string_view key);
  bool reset();

  scene::Scene loaded_;  ///< as the files have it
  scene::Scene scene_;
  uint32_t view_ = 0;
  bool wants_to_close_ = false;
};

}  // namespace texbrdf::viewing
