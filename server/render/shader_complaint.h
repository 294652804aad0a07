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

/// The first complaint with a place in the message of a RenderFault, or nothing where it has none.
std::optional<ShaderComplaint> find_complaint(std::string_view message);

}  // namespace texbrdf::render
