#pragma once

#include <string_view>

#include "plots/drawing.h"

namespace texbrdf::plots {

/// About how wide a text of DejaVu Sans is, in pixels.
double text_width(std::string_view text, double size);

}  // namespace texbrdf::plots
