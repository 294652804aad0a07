#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cli/exit_code.h"
#include "scene/scene.h"
#include "scene/scene_shader.h"

namespace texbrdf::cli {

/// Whether it is to be read as a scene or a part of one, by its name.
bool is_scene_file(const std::string& path);

struct CheckedScene {
  std::optional<scene::Scene> scene;  ///< where there is no error
  std::string report;                 ///< a line for each problem
  ExitCode exit_code = ExitCode::Fine;
};

/// Reads a scene, a model, a material, a shader or a primitive and all that it names, and tells what is wrong with it.
CheckedScene check_scene(const std::string& path);
/// Also what a compiler of GLSL finds in code of users: the first mistake.
CheckedScene check_scene_and_code(const std::string& path);

/// The line for a complaint of a compiler of GLSL (glslang or the driver); nothing where it is not about code of a
/// user.
std::optional<std::string> mistake_in_code(const scene::SceneShader& shader, std::string_view complaint);

}  // namespace texbrdf::cli
