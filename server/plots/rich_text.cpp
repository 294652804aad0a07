#include "plots/drawing.h"

namespace texbrdf::plots {
namespace {

std::size_t length_of_character(std::string_view text) {
  std::size_t length = 1;
  while (length < text.size() && (static_cast<unsigned char>(text[length]) & 0xC0U) == 0x80U) ++length;
  return length;
}

}  // namespace

Runs plain(std::string_view text) {
  return {{.text = std::string(text)}};
}

Runs rich(std::string_view text) {
  Runs runs;
  while (!text.empty()) {
    const bool is_script = text.size() > 1 && (text[0] == '_' || text[0] == '^');
    if (!is_script) {
      const std::string_view base = text.substr(0, text.find_first_of("_^", 1));
      runs.push_back({.text = std::string(base)});
      text.remove_prefix(base.size());
      continue;
    }
    const Script script = text[0] == '_' ? Script::Sub : Script::Super;
    text.remove_prefix(1);
    const std::size_t end = text.find('}');
    const bool has_braces = text[0] == '{' && end != std::string_view::npos;
    const std::size_t length = has_braces ? end + 1 : length_of_character(text);
    runs.push_back(
        {.text = std::string(has_braces ? text.substr(1, end - 1) : text.substr(0, length)), .script = script});
    text.remove_prefix(length);
  }
  return runs;
}

}  // namespace texbrdf::plots
