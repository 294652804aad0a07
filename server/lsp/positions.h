#pragma once

#include <cstdint>

#include "lsp/protocol.h"
#include "source/source_text.h"
#include "source/span.h"

namespace texbrdf::lsp {

/// Byte offsets of a text as positions of the protocol.
class Positions {
 public:
  Positions(const SourceText& text, ColumnUnit unit) : text_(text), unit_(unit) {}

  Position at(uint32_t offset) { return text_.position(offset, unit_); }
  Range range(Span span) { return {at(span.begin), at(span.end)}; }

 private:
  const SourceText& text_;
  ColumnUnit unit_;
};

}  // namespace texbrdf::lsp
