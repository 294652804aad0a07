#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace texbrdf::render {

// What a picture of a scene shows, in numbers: none of them is part of a shader's text but those of `SceneEffects`.

enum class SceneView : uint8_t {
#define SCENE_VIEW(name, word, meaning) name,
#include "render/scene_views.def"
#undef SCENE_VIEW
};

struct SceneViewEntry {
  SceneView view;
  std::string_view word;     ///< "shaded"
  std::string_view meaning;  ///< "the scene in its lights"
};

/// In the order of the enumerators.
std::span<const SceneViewEntry> scene_view_entries();

enum class Shadows : uint8_t { None, Hard, Soft };

/// What decides the shader's text beside the scene. Pictures that differ in nothing here need no compilation.
struct SceneEffects {
  Shadows shadows = Shadows::Hard;
  bool occlusion = false;
  bool slopes = false;  ///< for SceneView::Lipschitz
  friend bool operator==(const SceneEffects&, const SceneEffects&) = default;
};

/// How a scene is looked at; docs/pictures.md has the formulas.
struct SceneLook {
  SceneView view = SceneView::Shaded;
  Shadows shadows = Shadows::Hard;
  double light_size = 5;  ///< degrees under which a light appears, for soft shadows: 0.01 to 90
  bool occlusion = false;
  double occlusion_radius = 0.3;  ///< units within which surfaces keep ambient light away

  SceneEffects effects() const { return {shadows, occlusion, view == SceneView::Lipschitz}; }
  friend bool operator==(const SceneLook&, const SceneLook&) = default;
};

/// The numbers of a scene that may change from picture to picture.
struct SceneState {
  scene::Camera camera;
  std::vector<scene::Light> lights;
  scene::Environment environment;
  scene::RenderSettings settings;
  std::vector<float> frames;  ///< scene::scene_frames
};

/// A rectangle of a picture, in pixels from the top left.
struct SceneTile {
  uint32_t picture_width = 1;
  uint32_t picture_height = 1;
  uint32_t x = 0;
  uint32_t y = 0;
  uint32_t width = 1;
  uint32_t height = 1;

  std::size_t pixel_count() const { return std::size_t{width} * height; }
  friend bool operator==(const SceneTile&, const SceneTile&) = default;
};

inline constexpr std::size_t kMaxTilePixels = std::size_t{1} << 20;

/// Where in its pixel and in the ambient light's directions a sample lies, all in [0, 1).
struct SceneSample {
  std::array<float, 2> pixel{0.5F, 0.5F};  ///< from the lower left
  std::array<float, 2> ambient{0.5F, 0};
};

/// Samples of any number that lie evenly; the first is the middle of the pixel.
SceneSample scene_sample(uint32_t index);

/// Colours as a display wants them, for drawing straight to a window.
struct SceneDisplay {
  double gamma = 2.2;   ///< 0.1 to 10
  double exposure = 0;  ///< stops, -60 to 60
};

/// Why this cannot be drawn, in words, or nothing.
std::optional<std::string> find_fault(const SceneLook& look);
std::optional<std::string> find_fault(const SceneState& state);
std::optional<std::string> find_fault(const SceneTile& tile);
std::optional<std::string> find_fault(const SceneDisplay& display);

/// How the camera sees: the ray through (x, y) of the picture, each from -1 (left, bottom) to 1, is forward + x right +
/// y up.
struct CameraAxes {
  std::array<float, 3> eye;
  std::array<float, 3> forward;
  std::array<float, 3> right;
  std::array<float, 3> up;
};

/// `aspect` is width / height. Where `up` is parallel to the view, z (or x) takes its place.
CameraAxes camera_axes(const scene::Camera& camera, double aspect);

}  // namespace texbrdf::render
