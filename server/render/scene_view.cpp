#include "render/scene_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "render/sphere.h"
#include "scene/frame.h"

namespace texbrdf::render {

namespace {

constexpr std::array kEntries{
#define SCENE_VIEW(name, word, meaning) SceneViewEntry{SceneView::name, word, meaning},
#include "render/scene_views.def"
#undef SCENE_VIEW
};

/// The positive root of x^5 = x + 1: M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018.
constexpr double kRootOfFour = 1.1673039782614187;

bool is_finite(const scene::Triple& triple) {
  return std::ranges::all_of(triple, [](double x) { return std::isfinite(x); });
}

bool is_finite(const scene::Light& light) {
  if (const auto* directional = std::get_if<scene::DirectionalLight>(&light)) {
    return is_finite(directional->direction) && is_finite(directional->colour);
  }
  const auto& point = std::get<scene::PointLight>(light);
  return is_finite(point.position) && is_finite(point.colour);
}

bool has_direction(const scene::Light& light) {
  const auto* directional = std::get_if<scene::DirectionalLight>(&light);
  return directional == nullptr || std::isnormal(glm::length(scene::to_vector(directional->direction)));
}

std::array<float, 3> in_single_precision(const glm::dvec3& vector) {
  return {static_cast<float>(vector.x), static_cast<float>(vector.y), static_cast<float>(vector.z)};
}

/// At a right angle to `forward`; `up` may be parallel to it.
glm::dvec3 right_of(const glm::dvec3& forward, const glm::dvec3& up) {
  constexpr double kParallel = 1e-6;
  for (const glm::dvec3& candidate : {glm::normalize(up), glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0)}) {
    const glm::dvec3 right = glm::cross(forward, candidate);
    if (glm::length(right) > kParallel) return glm::normalize(right);
  }
  return {1, 0, 0};
}

}  // namespace

std::span<const SceneViewEntry> scene_view_entries() {
  return kEntries;
}

SceneSample scene_sample(uint32_t index) {
  std::array<float, 4> place{};
  const std::array<double, 4> start{0.5, 0.5, 0.5, 0};
  double step = 1;
  for (std::size_t i = 0; i < place.size(); ++i) {
    step /= kRootOfFour;
    const double value = start[i] + index * step;
    place[i] = std::min(static_cast<float>(value - std::floor(value)), std::nextafter(1.0F, 0.0F));
  }
  return {{place[0], place[1]}, {place[2], place[3]}};
}

std::optional<std::string> find_fault(const SceneLook& look) {
  if (!(look.light_size >= 0.01 && look.light_size <= 90)) {
    return fmt::format("lights appear under 0.01 to 90 degrees, not {}", look.light_size);
  }
  if (!(look.occlusion_radius > 0 && look.occlusion_radius <= 1e6)) {
    return fmt::format("the radius of ambient occlusion is more than 0 and at most a million, not {}",
                       look.occlusion_radius);
  }
  return std::nullopt;
}

std::optional<std::string> find_fault(const SceneState& state) {
  const scene::Camera& camera = state.camera;
  if (!is_finite(camera.position) || !is_finite(camera.target) || !is_finite(camera.up)) {
    return "the camera's place must be finite";
  }
  if (camera.position == camera.target) return "the camera's position and target must differ";
  if (camera.up == scene::Triple{0, 0, 0}) return "the camera's up must not be 0";
  if (!(camera.field_of_view > 0 && camera.field_of_view < 180)) {
    return fmt::format("the field of view is more than 0 and less than 180 degrees, not {}", camera.field_of_view);
  }
  if (state.lights.size() > scene::kMaxLights) return fmt::format("more than {} lights", scene::kMaxLights);
  if (!std::ranges::all_of(state.lights, [](const scene::Light& light) { return is_finite(light); })) {
    return "lights must be finite";
  }
  if (!std::ranges::all_of(state.lights, has_direction)) return "a light's direction must not be 0";
  if (!is_finite(state.environment.background) || !is_finite(state.environment.ambient)) {
    return "background and ambient light must be finite";
  }
  const scene::RenderSettings& settings = state.settings;
  if (settings.max_steps < 1 || settings.max_steps > 10'000) {
    return fmt::format("a ray has 1 to 10000 steps, not {}", settings.max_steps);
  }
  if (!(settings.max_distance > 0 && std::isfinite(settings.max_distance))) {
    return fmt::format("the longest distance must be more than 0, not {}", settings.max_distance);
  }
  if (!(settings.surface_threshold > 0 && settings.surface_threshold < settings.max_distance)) {
    return fmt::format("the threshold of surfaces must be more than 0 and less than the longest distance, not {}",
                       settings.surface_threshold);
  }
  if (state.frames.size() % 4 != 0) return "the frames of the dynamic objects are no whole vectors";
  return std::nullopt;
}

std::optional<std::string> find_fault(const SceneTile& tile) {
  const auto is_size = [](uint32_t pixels) { return pixels >= 1 && pixels <= kMaxPictureSize; };
  if (!is_size(tile.picture_width) || !is_size(tile.picture_height)) {
    return fmt::format("width and height of a picture are 1 to {} pixels, not {} x {}", kMaxPictureSize,
                       tile.picture_width, tile.picture_height);
  }
  const bool fits = is_size(tile.width) && is_size(tile.height) && tile.x <= tile.picture_width - tile.width &&
                    tile.y <= tile.picture_height - tile.height && tile.width <= tile.picture_width &&
                    tile.height <= tile.picture_height && tile.pixel_count() <= kMaxTilePixels;
  if (!fits) return "the part of the picture does not fit it";
  return std::nullopt;
}

std::optional<std::string> find_fault(const SceneDisplay& display) {
  if (!(display.gamma >= 0.1 && display.gamma <= 10)) return fmt::format("gamma is 0.1 to 10, not {}", display.gamma);
  if (!(std::abs(display.exposure) <= 60)) return fmt::format("exposure is -60 to 60, not {}", display.exposure);
  return std::nullopt;
}

CameraAxes camera_axes(const scene::Camera& camera, double aspect) {
  const glm::dvec3 eye = scene::to_vector(camera.position);
  const glm::dvec3 forward = glm::normalize(scene::to_vector(camera.target) - eye);
  const glm::dvec3 right = right_of(forward, scene::to_vector(camera.up));
  const glm::dvec3 up = glm::cross(right, forward);
  const double half_height = std::tan(camera.field_of_view * std::numbers::pi / 360);
  return {in_single_precision(eye), in_single_precision(forward), in_single_precision(right * half_height * aspect),
          in_single_precision(up * half_height)};
}

}  // namespace texbrdf::render
