#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace texbrdf {

/// Bytes of the code point at the front of a text that is not empty. A byte that begins no well-formed UTF-8 sequence
/// counts as a code point of its own.
struct CodePoint {
  uint32_t size = 1;
  bool well_formed = true;
};

CodePoint code_point_at_front(std::string_view text);

enum class ColumnUnit : uint8_t;
/// Columns that a code point takes: UTF-16 needs two units beyond the basic plane (four bytes of UTF-8).
uint32_t columns_of(uint32_t code_point_bytes, ColumnUnit unit);

uint32_t count_code_points(std::string_view text);

/// The text with every ill-formed byte and every control character replaced by U+FFFD, a tab by `tab`: safe to show.
std::string printable(std::string_view text, std::string_view tab = " ");

}  // namespace texbrdf
