#include "features/completion_text.h"

#include <fmt/format.h>

#include "features/name_index.h"

namespace texbrdf::features {
namespace {

/// Text in a snippet, or in one of its places.
std::string escaped(std::string_view text, bool in_place) {
  std::string out;
  for (const char c : text) {
    if (c == '\\' || c == '$' || (in_place && c == '}')) out += '\\';
    out += c;
  }
  return out;
}

}  // namespace

std::string call_snippet(std::string_view name, std::span<const std::string_view> parameters) {
  std::string snippet = escaped(name, false) + "(";
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    snippet += fmt::format("{}${{{}:{}}}", i == 0 ? "" : ", ", i + 1, escaped(parameters[i], true));
  }
  return snippet + ")";
}

std::string command_snippet(std::string_view spelling, std::string_view tail) {
  std::string snippet = escaped(spelling, false);
  int place = 0;
  for (const char c : tail) snippet += c == '#' ? fmt::format("${}", ++place) : escaped({&c, 1}, false);
  return snippet;
}

std::string command_label(std::string_view spelling, std::string_view tail) {
  std::string label(spelling);
  for (const char c : tail) label += c == '#' ? std::string("…") : std::string(1, c);
  return label;
}

std::string filter_text(std::string_view label, std::string_view typed, std::string_view key) {
  if (label.starts_with(typed)) return {};
  const std::string whole = typed.starts_with('\\') ? search_key(label) : bare_search_key(label);
  return fmt::format("{}{}", typed, std::string_view(whole).substr(key.size()));
}

}  // namespace texbrdf::features
