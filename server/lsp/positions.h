#pragma once

#include <cstdint>
#include <vector>

#include "source/source_text.h"
#include "source/span.h"

#include "lsp/protocol.h"

namespace texbrdf::lsp {

/// Byte offsets of a text as positions of the protocol. Many offsets of one very long line cost little each: the
/// line's columns are counted once.
class Positions {
 public:
  Positions(const SourceText& text, ColumnUnit unit) : text_(text), unit_(unit) {}

  Position at(uint32_t offset);
  Range range(Span span) { return {at(span.begin), at(span.end)}; }

 private:
  struct Checkpoint {
    uint32_t bytes = 0;
    uint32_t columns = 0;
  };
  uint32_t column(uint32_t line, uint32_t bytes);
  void count_line(uint32_t line);

  const SourceText& text_;
  ColumnUnit unit_;
  uint32_t counted_line_ = UINT32_MAX;
  std::vector<Checkpoint> checkpoints_;  ///< of the counted line, at code points, a fixed distance apart
};

}  // namespace texbrdf::lsp
