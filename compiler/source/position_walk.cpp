#include "source/position_walk.h"

#include <algorithm>

namespace texbrdf {

Position PositionWalk::at(uint32_t offset) {
  const uint32_t at = std::min(offset, text_.size());
  if (!is_in_chunk(at)) enter_chunk_of(at);
  if (chunk_.item == nullptr) return {};

  uint32_t in_chunk = at - chunk_.before.bytes;
  const std::string_view bytes = chunk_.item->bytes();
  const bool is_inside_ending =
      in_chunk > 0 && in_chunk < bytes.size() && bytes[in_chunk] == '\n' && bytes[in_chunk - 1] == '\r';
  if (is_inside_ending) --in_chunk;

  find_line_of(in_chunk);
  const uint32_t line = chunk_.before.line_ends + lines_begun_;
  const uint32_t columns = chunk_.item->columns_before(in_chunk, unit_);
  if (lines_begun_ == 0) return {line, columns_in_front_of_chunk() + columns};
  const uint32_t line_start = chunk_.item->line_starts()[lines_begun_ - 1];
  return {line, columns - chunk_.item->columns_before(line_start, unit_)};
}

void PositionWalk::find_line_of(uint32_t in_chunk) {
  const std::vector<uint16_t>& starts = chunk_.item->line_starts();
  const bool begins_before = lines_begun_ == 0 || starts[lines_begun_ - 1] <= in_chunk;
  const bool ends_behind = lines_begun_ == starts.size() || in_chunk < starts[lines_begun_];
  if (begins_before && ends_behind) return;
  lines_begun_ = static_cast<uint32_t>(std::ranges::upper_bound(starts, in_chunk) - starts.begin());
}

bool PositionWalk::is_in_chunk(uint32_t offset) const {
  return chunk_.item != nullptr && offset >= chunk_.before.bytes &&
         offset - chunk_.before.bytes < chunk_.item->measure().bytes;
}

void PositionWalk::enter_chunk_of(uint32_t offset) {
  const Sequence<TextChunk>& chunks = text_.chunks();
  chunk_ = chunks.find([&](const TextChunk::Measure& sum) { return sum.bytes > offset; });
  if (chunk_.item == nullptr && !chunks.empty()) chunk_ = chunks.at(chunks.size() - 1);
  columns_in_front_.reset();
  lines_begun_ = 0;
}

uint32_t PositionWalk::columns_in_front_of_chunk() {
  if (!columns_in_front_) {
    const uint32_t line_start = text_.line_start(chunk_.before.line_ends);
    columns_in_front_ = chunk_.before.columns(unit_) - text_.columns_before(line_start, unit_);
  }
  return *columns_in_front_;
}

}  // namespace texbrdf
