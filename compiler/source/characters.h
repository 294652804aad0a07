#pragma once

namespace texbrdf {

/// ASCII alone: what TeX takes for a letter of a command.
constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
constexpr bool is_line_end(char c) {
  return c == '\n' || c == '\r';
}
/// Within a line.
constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t';
}
constexpr bool is_space(char c) {
  return is_blank(c) || is_line_end(c) || c == '\f' || c == '\v';
}

}  // namespace texbrdf
