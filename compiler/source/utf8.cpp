#include "source/utf8.h"

#include "source/source_text.h"

#include <utf8.h>

namespace texbrdf {
namespace {

uint32_t sequence_length(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead < 0xE0) return 2;
  if (lead >= 0xE0 && lead < 0xF0) return 3;
  if (lead >= 0xF0 && lead < 0xF5) return 4;
  return 0;
}

bool is_control(std::string_view code_point) {
  const auto first = static_cast<unsigned char>(code_point[0]);
  if (code_point.size() == 1) return first < 0x20 || first == 0x7F;
  const bool is_c1 = first == 0xC2 && static_cast<unsigned char>(code_point[1]) < 0xA0;
  // U+200B … U+200F, U+2028 … U+202E, U+2066 … U+2069: they would reorder or hide what is shown.
  const bool is_format =
      code_point.substr(0, 2) == "\xE2\x80"
          ? (code_point[2] >= '\x8B' && code_point[2] <= '\x8F') || (code_point[2] >= '\xA8' && code_point[2] <= '\xAE')
          : code_point.substr(0, 2) == "\xE2\x81" && code_point[2] >= '\xA6' && code_point[2] <= '\xA9';
  return is_c1 || is_format;
}

}  // namespace

CodePoint code_point_at_front(std::string_view text) {
  const uint32_t size = sequence_length(static_cast<unsigned char>(text[0]));
  if (size == 1) return {1, true};
  if (size == 0 || size > text.size() || !utf8::is_valid(text.begin(), text.begin() + size)) return {1, false};
  return {size, true};
}

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

uint32_t count_code_points(std::string_view text) {
  uint32_t count = 0;
  for (; !text.empty(); ++count) text.remove_prefix(code_point_at_front(text).size);
  return count;
}

std::string printable(std::string_view text, std::string_view tab) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const CodePoint next = code_point_at_front(text);
    const std::string_view code_point = text.substr(0, next.size);
    if (code_point == "\t") {
      shown += tab;
    } else {
      shown += next.well_formed && !is_control(code_point) ? code_point : std::string_view("\uFFFD");
    }
    text.remove_prefix(next.size);
  }
  return shown;
}

}  // namespace texbrdf
