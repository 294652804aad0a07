#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace texbrdf::render {

/// What a compiler of GLSL says of a place: `1:12: 'x' : undeclared identifier`.
struct ShaderComplaint {
  uint32_t source = 0;  ///< as `#line` numbers it
  uint32_t line = 0;
  std::string message;
};

/// The place and words of what GlslChecker says, or of the message of a RenderFault; nothing where it names no place.
std::optional<ShaderComplaint> find_complaint(std::string_view message);

}  // namespace texbrdf::render
