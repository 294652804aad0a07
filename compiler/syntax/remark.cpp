#include "syntax/remark.h"

#include <algorithm>
#include <array>
#include <string>

#include "source/characters.h"

namespace texbrdf {
namespace {

constexpr auto kIntroductions = std::to_array<std::string_view>(
    {"if", "iff", "for", "when", "whenever", "where", "wherever", "while", "with", "as", "provided", "given", "in"});
constexpr auto kDefaults = std::to_array<std::string_view>({"otherwise", "else", "elsewhere", "other"});
constexpr auto kBareRemarks =
    std::to_array<std::string_view>({"if", "for", "when", "where", "otherwise", "else", "elsewhere"});
constexpr size_t kLongestWord = 16;

template <size_t N>
bool holds(const std::array<std::string_view, N>& words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

/// Takes the next word, in small letters, off the front; empty at the end.
std::string take_word(std::string_view& text) {
  text.remove_prefix(static_cast<size_t>(std::ranges::find_if(text, is_letter) - text.begin()));
  const auto size = static_cast<size_t>(std::ranges::find_if_not(text, is_letter) - text.begin());
  std::string word(text.substr(0, std::min(size, kLongestWord)));
  for (char& c : word) c = static_cast<char>(c | 0x20);
  text.remove_prefix(size);
  return word;
}

/// Without the command in front, as in `\text{` and `{\rm `.
std::string_view without_command(std::string_view source) {
  if (source.starts_with('{')) source.remove_prefix(1);
  if (!source.starts_with('\\')) return source;
  source.remove_prefix(1);
  return source.substr(static_cast<size_t>(std::ranges::find_if_not(source, is_letter) - source.begin()));
}

/// `\text{ (isotropic)}`
bool is_aside(std::string_view source) {
  const std::string_view content = without_command(source);
  const size_t first = content.find_first_not_of(" \t\r\n~{");
  return first != std::string_view::npos && content[first] == '(';
}

}  // namespace

RemarkKind read_remark(std::string_view source) {
  std::string_view rest = without_command(source);
  const std::string first = take_word(rest);
  if (first.empty()) return RemarkKind::Nothing;
  if (first == "and") return RemarkKind::And;
  if (first == "or") return RemarkKind::Or;
  bool says_if = false;
  bool says_otherwise = false;
  for (std::string word = first; !word.empty(); word = take_word(rest)) {
    says_if = says_if || word == "if";
    says_otherwise = says_otherwise || holds(kDefaults, word);
  }
  if (says_otherwise && !says_if) return RemarkKind::Otherwise;
  if (says_otherwise || holds(kIntroductions, first)) return RemarkKind::Introduction;
  return is_aside(source) ? RemarkKind::Nothing : RemarkKind::Unknown;
}

bool holds_words(std::string_view source) {
  std::string_view rest = without_command(source);
  return !take_word(rest).empty();
}

bool starts_condition(std::string_view source) {
  std::string_view rest = without_command(source);
  const std::string first = take_word(rest);
  return first == "if" || first == "when" || first == "for";
}

bool is_bare_remark(std::string_view word) {
  return holds(kBareRemarks, word);
}

}  // namespace texbrdf
