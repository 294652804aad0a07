#pragma once

#include <cstdint>
#include <optional>

#include "source/source_text.h"

namespace texbrdf {

/// Positions in a text, cheap where many are asked for that lie near each other. The text has to stay.
class PositionWalk {
 public:
  PositionWalk(const SourceText& text, ColumnUnit unit) : text_(text), unit_(unit) {}

  /// As SourceText::position.
  Position at(uint32_t offset);

 private:
  bool is_in_chunk(uint32_t offset) const;
  void enter_chunk_of(uint32_t offset);
  void find_line_of(uint32_t in_chunk);
  uint32_t columns_in_front_of_chunk();

  const SourceText& text_;
  ColumnUnit unit_;
  Sequence<TextChunk>::Place chunk_;
  std::optional<uint32_t> columns_in_front_;  // of the line that is open where the chunk begins
  uint32_t lines_begun_ = 0;                  // in the chunk, up to the last place
};

}  // namespace texbrdf
