#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "scene/scene_shader.h"

namespace texbrdf::scene_json {

/// What a compiler of GLSL says of a line of a scene's shader, told at its place in the user's file as `describe` tells
/// problems; nothing where the line is not a user's. `source` and `line` are those of `#line`.
std::optional<std::string> describe_code_mistake(const scene::SceneShader& shader, uint32_t source, uint32_t line,
                                                 std::string_view message, std::string_view folder = {});

}  // namespace texbrdf::scene_json
