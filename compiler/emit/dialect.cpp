#include "emit/dialect.h"

#include <algorithm>
#include <array>
#include <string>

#include "emit/helpers.h"

namespace texbrdf::emit {
namespace {

constexpr auto kGlslWords = std::to_array<std::string_view>({
#define WORDS(words) words,
#include "emit/glsl_words.def"
#undef WORDS
});

constexpr auto kExplorerWords = std::to_array<std::string_view>({
#define WORDS(words) words,
#define PREFIX(text)
#define SUFFIX(text)
#include "emit/explorer_words.def"
#undef WORDS
#undef PREFIX
#undef SUFFIX
});

constexpr auto kExplorerPrefixes = std::to_array<std::string_view>({
#define WORDS(words)
#define PREFIX(text) text,
#define SUFFIX(text)
#include "emit/explorer_words.def"
#undef WORDS
#undef PREFIX
#undef SUFFIX
});

constexpr auto kExplorerSuffixes = std::to_array<std::string_view>({
#define WORDS(words)
#define PREFIX(text)
#define SUFFIX(text) text,
#include "emit/explorer_words.def"
#undef WORDS
#undef PREFIX
#undef SUFFIX
});

/// `words` is a list separated by single spaces.
bool holds_word(std::string_view words, std::string_view word) {
  for (std::size_t at = words.find(word); at != std::string_view::npos; at = words.find(word, at + 1)) {
    std::size_t end = at + word.size();
    if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || words[end] == ' ')) return true;
  }
  return false;
}

bool any_holds(std::span<const std::string_view> lists, std::string_view word) {
  return std::ranges::any_of(lists, [&](std::string_view words) { return holds_word(words, word); });
}

}  // namespace

const Dialect kGlslDialect{.entry_point = "brdf", .zero_below_horizon = false, .host = {}};

const Dialect kExplorerDialect{
    .entry_point = "BRDF",
    .zero_below_horizon = true,
    .host = {.words = kExplorerWords, .prefixes = kExplorerPrefixes, .suffixes = kExplorerSuffixes}};

bool is_forbidden(const Dialect& dialect, std::string_view name) {
  if (name.starts_with("gl_") || name.find("__") != std::string_view::npos) return true;
  if (name == dialect.entry_point || any_holds(kGlslWords, name) || is_helper_name(name)) return true;
  const ForbiddenNames& host = dialect.host;
  return any_holds(host.words, name) ||
         std::ranges::any_of(host.prefixes, [&](std::string_view prefix) { return name.starts_with(prefix); }) ||
         std::ranges::any_of(host.suffixes, [&](std::string_view suffix) { return name.ends_with(suffix); });
}

}  // namespace texbrdf::emit
