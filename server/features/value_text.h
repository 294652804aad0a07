#pragma once

#include <span>
#include <string>

namespace texbrdf::features {

/// As people read it: 0.25, or (1, 0, 0.5) for a vector.
std::string value_text(std::span<const double> value, int digits = 7);

}  // namespace texbrdf::features
