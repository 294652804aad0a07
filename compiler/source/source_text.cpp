#include "source/source_text.h"

#include <algorithm>

#include "source/utf8.h"

namespace texbrdf {
namespace {

std::vector<uint32_t> find_line_starts(std::string_view bytes) {
  std::vector<uint32_t> starts = {0};
  const char* const data = bytes.data();
  const size_t size = bytes.size();
  for (size_t i = 0; i < size; ++i) {
    if (data[i] > '\r') continue;
    const bool line_feed = data[i] == '\n';
    const bool lone_return = data[i] == '\r' && !(i + 1 < size && data[i + 1] == '\n');
    if (line_feed || lone_return) starts.push_back(static_cast<uint32_t>(i + 1));
  }
  return starts;
}

/// Columns that the code point takes: UTF-16 needs two units beyond the basic plane (four bytes of UTF-8).
uint32_t columns_of(CodePoint code_point, ColumnUnit unit) {
  switch (unit) {
    case ColumnUnit::Utf8:
      return code_point.size;
    case ColumnUnit::Utf16:
      return code_point.size == 4 ? 2 : 1;
    case ColumnUnit::CodePoint:
      return 1;
  }
  return 1;
}

struct LineWalk {
  uint32_t bytes = 0;
  uint32_t columns = 0;
};

/// Walks whole code points of the line as long as neither limit is passed.
LineWalk walk(std::string_view line, uint32_t max_bytes, uint32_t max_columns, ColumnUnit unit) {
  LineWalk at;
  while (at.bytes < line.size()) {
    const bool ascii = static_cast<unsigned char>(line[at.bytes]) < 0x80;
    const CodePoint next = ascii ? CodePoint{} : code_point_at_front(line.substr(at.bytes));
    const uint32_t columns = columns_of(next, unit);
    if (at.bytes + next.size > max_bytes || at.columns + columns > max_columns) break;
    at.bytes += next.size;
    at.columns += columns;
  }
  return at;
}

}  // namespace

SourceText::SourceText(std::string bytes) : bytes_(std::move(bytes)) {
  if (bytes_.size() > kMaxBytes) bytes_.resize(kMaxBytes);
  line_starts_ = find_line_starts(bytes_);
}

std::string_view SourceText::slice(Span span) const {
  const uint32_t begin = std::min(span.begin, size());
  const uint32_t end = std::clamp(span.end, begin, size());
  return bytes().substr(begin, end - begin);
}

std::string_view SourceText::line(uint32_t line) const {
  if (line >= line_count()) return {};
  const uint32_t begin = line_starts_[line];
  const uint32_t end = line + 1 < line_count() ? line_starts_[line + 1] : size();
  std::string_view text = bytes().substr(begin, end - begin);
  if (text.ends_with('\n')) text.remove_suffix(1);
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

Position SourceText::position(uint32_t offset, ColumnUnit unit) const {
  const uint32_t at = std::min(offset, size());
  const auto behind = std::upper_bound(line_starts_.begin(), line_starts_.end(), at);
  const auto line_number = static_cast<uint32_t>(behind - line_starts_.begin()) - 1;
  const uint32_t in_line = at - line_starts_[line_number];
  if (unit == ColumnUnit::Utf8) {
    return {line_number, std::min(in_line, static_cast<uint32_t>(line(line_number).size()))};
  }
  return {line_number, walk(line(line_number), in_line, UINT32_MAX, unit).columns};
}

uint32_t SourceText::offset(Position position, ColumnUnit unit) const {
  if (position.line >= line_count()) return size();
  return line_starts_[position.line] + walk(line(position.line), UINT32_MAX, position.column, unit).bytes;
}

}  // namespace texbrdf
