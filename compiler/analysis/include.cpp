#include "analysis/include.h"

#include <algorithm>
#include <cctype>

#include "source/trimmed.h"

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

std::optional<std::string> root_of_comment(std::string_view document) {
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

std::string without_comments(std::string_view document) {
  std::string result;
  bool is_comment = false;
  bool is_escaped = false;
  for (const char c : document) {
    if (c == '\n' || c == '\r') is_comment = false;
    if (c == '%' && !is_escaped) is_comment = true;
    if (!is_comment) result += c;
    is_escaped = c == '\\' && !is_escaped;
  }
  return result;
}

/// Takes `[…]` or `{…}` from the front of the text and gives what stands in it.
std::optional<std::string_view> take_group(std::string_view& text, char open, char close) {
  text = trimmed(text);
  const size_t end = text.find(close);
  if (!text.starts_with(open) || end == std::string_view::npos) return std::nullopt;
  const std::string_view inside = text.substr(1, end - 1);
  text.remove_prefix(end + 1);
  return trimmed(inside);
}

std::optional<std::string> root_of_subfile(std::string_view document) {
  constexpr std::string_view kCommand = "\\documentclass";
  const std::string text = without_comments(document);
  const size_t at = text.find(kCommand);
  if (at == std::string::npos) return std::nullopt;
  std::string_view rest = std::string_view(text).substr(at + kCommand.size());
  const auto root = take_group(rest, '[', ']');
  if (!root || root->empty() || take_group(rest, '{', '}') != "subfiles") return std::nullopt;
  return std::string(*root);
}

}  // namespace

std::optional<std::string> read_root(std::string_view document) {
  std::optional<std::string> root = root_of_comment(document);
  return root ? root : root_of_subfile(document);
}

}  // namespace texbrdf
