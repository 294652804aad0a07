#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

#include "cli/exit_code.h"
#include "cli/picture_size.h"
#include "render/scene_view.h"

namespace texbrdf::cli {

/// The group of options that only scenes take.
inline constexpr const char* kSceneGroup = "Options for scenes";

/// What `render` is told of a picture of a scene.
struct SceneOptions {
  render::SceneLook look;
  uint32_t samples = 1;
  std::optional<uint32_t> max_steps;  ///< in the place of what the scene says, as the two after it
  std::optional<double> max_distance;
  std::optional<double> surface_threshold;
};

/// Declares them, in kSceneGroup.
void add_scene_options(CLI::App& arguments, SceneOptions& options);

/// Draws a *.scene.json, or a model, material, shader or primitive by itself, and writes a PNG.
ExitCode render_scene(const std::string& path, const SceneOptions& options, PictureSize size,
                      const render::SceneDisplay& display, const std::string& output);

}  // namespace texbrdf::cli
