#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "source/result.h"

namespace texbrdf::objects {

/// What is wrong with a .obj file line by line, which its reader would take for zeros or leave out: words that are no
/// numbers, numbers that are not finite or beyond a float, places that do not exist, more of anything than the limits
/// of obj_file.h allow.
std::optional<Failure> find_obj_fault(std::string_view text);

}  // namespace texbrdf::objects
