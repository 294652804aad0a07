#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"
#include "source/result.h"

namespace texbrdf::scene_json {

/// `[float] [Range(0, 1)] _Blend`, also with ` = 0.5` or ` = (0.5, 0.1, 0.5)` behind it.
Result<scene::Property> read_property(std::string_view text);

/// "0.5" or "(0.5, 0.1, 0.5)"; nothing where it is neither.
std::optional<std::vector<double>> read_tuple(std::string_view text);

/// The numbers as a value of the type, or why they are none.
Result<scene::Triple> value_of(const std::vector<double>& numbers, scene::PropertyType type);

bool is_identifier(std::string_view text);

}  // namespace texbrdf::scene_json
