#pragma once

#include <cstdint>
#include <string_view>

#include "syntax/math_regions.h"

namespace texbrdf {

/// How a math block ended.
enum class BlockEnd : uint8_t {
  Closed,     ///< by what belongs to its begin
  WrongEnd,   ///< by an \end of another environment, by `$` instead of `$$`
  NextBegin,  ///< by the next \begin of an equation
  BlankLine,
  DocumentEnd,  ///< \end{document} or the end of the file
};

/// Where a formula ends that no environment closes, in bytes of the text.
struct FormulaEnd {
  BlockEnd ended_by = BlockEnd::Closed;
  uint32_t content_end = 0;
  uint32_t end = 0;           ///< behind what closes it; else `content_end`
  uint32_t decided_at = 0;    ///< nothing from here on was looked at
  bool has_relation = false;  ///< it may define something: a `=`, `\approx` … stands in no braces
};

/// `begin`: behind the opener; `shortcut`: what that is where the region is one. Linear in the formula, which a blank
/// line ends at the latest. Not for fences.
FormulaEnd find_formula_end(std::string_view text, uint32_t begin, MathRegion region,
                            const MathShortcut* shortcut = nullptr);

}  // namespace texbrdf
