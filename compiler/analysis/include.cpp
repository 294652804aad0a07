#include "analysis/include.h"

#include <algorithm>
#include <cctype>

namespace texbrdf {
namespace {

/// Editors look for the comment no further.
constexpr int kFirstLines = 20;
constexpr std::string_view kBlanks = " \t";

std::string_view without_blanks_in_front(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(kBlanks), text.size()));
}

bool same_letters(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
  return std::ranges::equal(a, b, {}, lower, lower);
}

/// Takes the word from the front of the text; false where another stands there.
bool take(std::string_view& text, std::string_view word) {
  text = without_blanks_in_front(text);
  if (!same_letters(text.substr(0, word.size()), word)) return false;
  text.remove_prefix(word.size());
  return true;
}

}  // namespace

std::optional<std::string> read_root_comment(std::string_view document) {
  for (int i = 0; i < kFirstLines && !document.empty(); ++i) {
    const size_t end = std::min(document.find_first_of("\r\n"), document.size());
    std::string_view line = document.substr(0, end);
    document.remove_prefix(std::min(end + 1, document.size()));
    if (!take(line, "%") || !take(line, "!TeX") || !take(line, "root") || !take(line, "=")) continue;
    line = without_blanks_in_front(line);
    line = line.substr(0, line.find_last_not_of(kBlanks) + 1);
    if (!line.empty()) return std::string(line);
  }
  return std::nullopt;
}

}  // namespace texbrdf
