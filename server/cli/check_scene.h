#pragma once

#include <optional>
#include <string>

#include "cli/exit_code.h"
#include "scene/scene.h"

namespace texbrdf::cli {

/// Whether it is to be read as a scene or a part of one, by its name.
bool is_scene_file(const std::string& path);

struct CheckedScene {
  std::optional<scene::Scene> scene;  ///< where there is no error
  std::string report;                 ///< a line for each problem
  ExitCode exit_code = ExitCode::Fine;
};

/// What is wrong with a scene, a model, a material, a shader or a primitive and all that it names.
CheckedScene check_scene(const std::string& path);

}  // namespace texbrdf::cli
