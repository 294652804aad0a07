#include "lsp/positions.h"

#include <algorithm>

#include "source/utf8.h"

namespace texbrdf::lsp {
namespace {

constexpr uint32_t kCheckpointDistance = 64;

uint32_t columns_of(uint32_t code_point_bytes, ColumnUnit unit) {
  switch (unit) {
    case ColumnUnit::Utf8:
      return code_point_bytes;
    case ColumnUnit::Utf16:
      return code_point_bytes == 4 ? 2 : 1;
    case ColumnUnit::CodePoint:
      return 1;
  }
  return 1;
}

}  // namespace

Position Positions::at(uint32_t offset) {
  const Position in_bytes = text_.position(offset, ColumnUnit::Utf8);
  if (unit_ == ColumnUnit::Utf8) return in_bytes;
  if (in_bytes.column < kCheckpointDistance) return text_.position(offset, unit_);
  return {in_bytes.line, column(in_bytes.line, in_bytes.column)};
}

uint32_t Positions::column(uint32_t line, uint32_t bytes) {
  if (line != counted_line_) count_line(line);
  const auto behind = std::upper_bound(checkpoints_.begin(), checkpoints_.end(), bytes,
                                       [](uint32_t wanted, const Checkpoint& at) { return wanted < at.bytes; });
  Checkpoint at = *std::prev(behind);
  const std::string_view text = text_.line(line);
  while (at.bytes < bytes) {
    const uint32_t size = code_point_at_front(text.substr(at.bytes)).size;
    if (at.bytes + size > bytes) break;
    at.bytes += size;
    at.columns += columns_of(size, unit_);
  }
  return at.columns;
}

void Positions::count_line(uint32_t line) {
  counted_line_ = line;
  checkpoints_.assign(1, {});
  const std::string_view text = text_.line(line);
  Checkpoint at;
  while (at.bytes < text.size()) {
    const uint32_t size = code_point_at_front(text.substr(at.bytes)).size;
    at.bytes += size;
    at.columns += columns_of(size, unit_);
    if (at.bytes - checkpoints_.back().bytes >= kCheckpointDistance) checkpoints_.push_back(at);
  }
}

}  // namespace texbrdf::lsp
