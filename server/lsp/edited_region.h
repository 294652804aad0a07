#pragma once

#include <algorithm>
#include <cstdint>

#include "source/span.h"

namespace texbrdf::lsp {

/// What is surely the same in two versions of a text: so many bytes at its front and at its back. All edits between
/// the versions lie in between.
struct EditedRegion {
  uint32_t kept_front = UINT32_MAX;
  uint32_t kept_back = UINT32_MAX;

  /// The span of a text of that size was replaced.
  void add(Span replaced, uint32_t text_size) {
    const uint32_t end = std::min(replaced.end, text_size);
    kept_front = std::min({kept_front, replaced.begin, end});
    kept_back = std::min(kept_back, text_size - end);
  }
  void add_whole_text() { kept_front = kept_back = 0; }
};

}  // namespace texbrdf::lsp
