#include "lsp/json_limits.h"

#include <fmt/format.h>

#include <charconv>

namespace texbrdf::lsp {
namespace {

/// The offset behind the string that starts at `begin`.
std::size_t string_end(std::string_view text, std::size_t begin) {
  std::size_t i = text.find_first_of("\"\\", begin + 1);
  while (i != std::string_view::npos && text[i] == '\\') i = text.find_first_of("\"\\", i + 2);
  return i == std::string_view::npos ? text.size() : i + 1;
}

/// The number of a `\uXXXX` at `offset`, 0 where none stands.
uint32_t unicode_escape(std::string_view text, std::size_t offset) {
  if (offset + 6 > text.size() || text[offset] != '\\' || text[offset + 1] != 'u') return 0;
  uint32_t number = 0;
  const char* end = text.data() + offset + 6;
  return std::from_chars(text.data() + offset + 2, end, number, 16).ptr == end ? number : 0;
}

bool is_high_surrogate(uint32_t number) {
  return number >= 0xD800 && number < 0xDC00;
}

bool is_low_surrogate(uint32_t number) {
  return number >= 0xDC00 && number < 0xE000;
}

}  // namespace

std::optional<std::string> exceeds_json_limits(std::string_view text) {
  uint32_t depth = 0;
  uint32_t values = 1;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"') {
      i = string_end(text, i);
      continue;
    }
    if (c == '[' || c == '{') ++depth;
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if (c == '[' || c == '{' || c == ',') ++values;
    if (depth > kMaxJsonDepth) return fmt::format("JSON nested deeper than {}", kMaxJsonDepth);
    if (values > kMaxJsonValues) return fmt::format("JSON with more than {} values", kMaxJsonValues);
    ++i;
  }
  return std::nullopt;
}

std::string without_lone_surrogates(std::string_view text) {
  std::string result(text);
  for (std::size_t i = result.find('\\'); i != std::string::npos && i + 1 < result.size(); i = result.find('\\', i)) {
    const uint32_t number = unicode_escape(result, i);
    if (is_high_surrogate(number) && is_low_surrogate(unicode_escape(result, i + 6))) {
      i += 12;
    } else if (is_high_surrogate(number) || is_low_surrogate(number)) {
      result.replace(i, 6, "\\ufffd");
      i += 6;
    } else {
      i += 2;
    }
  }
  return result;
}

}  // namespace texbrdf::lsp
