#pragma once

#include <string_view>

#include "source/span.h"

namespace texbrdf {

/// Bytes of a text and what stands in their place in another.
struct TextChange {
  Span span;
  std::string_view replacement;  ///< of the text after
};

/// What the texts have in common at their front and at their back is left out.
TextChange smallest_change(std::string_view before, std::string_view after);

}  // namespace texbrdf
