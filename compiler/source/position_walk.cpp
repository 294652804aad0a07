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

  const std::vector<uint16_t>& starts = chunk_.item->line_starts();
  const auto behind = std::ranges::upper_bound(starts, in_chunk);
  const uint32_t line = chunk_.before.line_ends + static_cast<uint32_t>(behind - starts.begin());
  const uint32_t columns = chunk_.item->columns_before(in_chunk, unit_);
  if (behind == starts.begin()) return {line, columns_in_front_of_chunk() + columns};
  return {line, columns - chunk_.item->columns_before(*std::prev(behind), unit_)};
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
}

uint32_t PositionWalk::columns_in_front_of_chunk() {
  if (!columns_in_front_) {
    const uint32_t line_start = text_.line_start(chunk_.before.line_ends);
    columns_in_front_ = chunk_.before.columns(unit_) - text_.columns_before(line_start, unit_);
  }
  return *columns_in_front_;
}

}  // namespace texbrdf
