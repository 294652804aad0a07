#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace texbrdf::emit {

/// Line comments that show an equation, under 100 columns, in plain ASCII (older GLSL allows no other characters, not
/// even in comments), and never ending in a backslash, which would pull the next line into the comment.
std::string equation_comment(std::string_view equation, uint32_t indent);

}  // namespace texbrdf::emit
