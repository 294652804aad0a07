#pragma once

#include <string>

#include "plots/drawing.h"

namespace texbrdf::plots {

/// Coordinates are rounded to a hundredth of a pixel. Text stays text.
std::string write_svg(const Drawing& drawing);

}  // namespace texbrdf::plots
