#pragma once

#include <string>
#include <string_view>

#include "syntax/print_tree_svg.h"

namespace texbrdf {

// Font sizes and places of the text in a box, in px.
inline constexpr double kTitleFontSize = 14;
inline constexpr double kSubtitleFontSize = 11;
inline constexpr double kHeadingFontSize = 16;
inline constexpr double kTitleBaseline = 19;
inline constexpr double kSubtitleBaseline = 34;

/// At least what the text takes in a monospaced font of this size.
double text_width(std::string_view text, double font_size);

/// The label as it is drawn: long lines are cut.
NodeLabel shown_label(const NodeLabel& label);
std::string shown_heading(std::string_view heading);

}  // namespace texbrdf
