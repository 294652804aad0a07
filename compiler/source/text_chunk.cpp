#include "source/source_text.h"
#include "source/utf8.h"

namespace texbrdf {
namespace {

struct Walk {
  uint32_t bytes = 0;
  uint32_t columns = 0;
};

/// Walks whole code points as long as neither limit is passed.
Walk walk(std::string_view text, uint32_t max_bytes, uint32_t max_columns, ColumnUnit unit) {
  Walk at;
  while (at.bytes < text.size()) {
    const bool is_ascii = static_cast<unsigned char>(text[at.bytes]) < 0x80;
    const uint32_t bytes = is_ascii ? 1 : code_point_at_front(text.substr(at.bytes)).size;
    const uint32_t columns = columns_of(bytes, unit);
    if (at.bytes + bytes > max_bytes || at.columns + columns > max_columns) break;
    at.bytes += bytes;
    at.columns += columns;
  }
  return at;
}

bool all_ascii(std::string_view text) {
  unsigned char any = 0;
  for (const char c : text) any |= static_cast<unsigned char>(c);
  return any < 0x80;
}

std::vector<uint16_t> find_line_starts(std::string_view bytes) {
  std::vector<uint16_t> starts;
  for (size_t i = 0; i < bytes.size(); ++i) {
    if (bytes[i] > '\r') continue;
    const bool is_lone_return = bytes[i] == '\r' && !(i + 1 < bytes.size() && bytes[i + 1] == '\n');
    if (bytes[i] == '\n' || is_lone_return) starts.push_back(static_cast<uint16_t>(i + 1));
  }
  return starts;
}

}  // namespace

uint32_t TextChunk::Measure::columns(ColumnUnit unit) const {
  switch (unit) {
    case ColumnUnit::Utf8:
      return bytes;
    case ColumnUnit::Utf16:
      return utf16;
    case ColumnUnit::CodePoint:
      return code_points;
  }
  return bytes;
}

TextChunk::TextChunk(std::string_view bytes)
    : content_(std::make_shared<const Content>(Content{std::string(bytes), find_line_starts(bytes)})) {
  const auto size = static_cast<uint32_t>(bytes.size());
  measure_ = {size, static_cast<uint32_t>(line_starts().size()), size, size};
  if (all_ascii(bytes)) return;
  measure_.utf16 = walk(bytes, size, UINT32_MAX, ColumnUnit::Utf16).columns;
  measure_.code_points = walk(bytes, size, UINT32_MAX, ColumnUnit::CodePoint).columns;
}

uint32_t TextChunk::columns_before(uint32_t byte, ColumnUnit unit) const {
  return is_ascii() ? byte : walk(bytes(), byte, UINT32_MAX, unit).columns;
}

uint32_t TextChunk::bytes_of(uint32_t columns, ColumnUnit unit) const {
  return is_ascii() ? columns : walk(bytes(), UINT32_MAX, columns, unit).bytes;
}

}  // namespace texbrdf
