#include "semantics/nearest_name.h"

#include <algorithm>
#include <array>
#include <bit>

#include "syntax/control_words.h"

namespace texbrdf {
namespace {

// Longer names are not compared: the time grows with the square of the length.
constexpr size_t kLongest = 48;

/// The length of the command in front that only says how a name looks, or 0.
size_t decoration_length(std::string_view text) {
  if (!text.starts_with('\\')) return 0;
  size_t end = 1;
  while (end < text.size() && ((text[end] >= 'a' && text[end] <= 'z') || (text[end] >= 'A' && text[end] <= 'Z'))) ++end;
  const ControlWord& word = find_control_word(text.substr(1, end - 1));
  const bool is_silent =
      word.meaning == WordMeaning::Text || word.meaning == WordMeaning::TextDeclaration || word.kind == TokenKind::Vec;
  return is_silent ? end : 0;
}

// What is left of a name without decoration: `\rho_{\text{diff}}` gives "rho_diff".
std::string letters_of(std::string_view name) {
  std::string letters;
  for (size_t i = 0; i < name.size(); ++i) {
    i += decoration_length(name.substr(i));
    if (i < name.size() && name[i] != '\\' && name[i] != '{' && name[i] != '}' && name[i] != ' ') letters += name[i];
  }
  return letters;
}

std::string lower_case(std::string text) {
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

uint64_t letters_in(std::string_view letters) {
  uint64_t which = 0;
  for (char c : letters) which |= uint64_t{1} << (static_cast<unsigned char>(c) % 64);
  return which;
}

// Each edit adds or takes away at most one kind of letter on either side.
size_t least_distance(uint64_t a, uint64_t b) {
  return static_cast<size_t>(std::max(std::popcount(a & ~b), std::popcount(b & ~a)));
}

// One letter in three may be wrong; a shorter name says too little.
size_t most_edits(std::string_view letters) {
  return static_cast<size_t>(std::ranges::count_if(letters, [](char c) { return c != '_'; })) / 3;
}

/// Insertions, deletions, substitutions and swaps of neighbours; `limit` + 1 where there are more.
size_t edit_distance(std::string_view a, std::string_view b, size_t limit) {
  const size_t difference = a.size() > b.size() ? a.size() - b.size() : b.size() - a.size();
  if (difference > limit) return limit + 1;
  std::array<std::array<size_t, kLongest + 1>, 3> rows{};
  for (size_t j = 0; j <= b.size(); ++j) rows[0][j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    auto& row = rows[i % 3];
    const auto& above = rows[(i + 2) % 3];
    const auto& two_above = rows[(i + 1) % 3];
    row[0] = i;
    size_t least = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool is_swap = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (is_swap) row[j] = std::min(row[j], two_above[j - 2] + 1);
      least = std::min(least, row[j]);
    }
    if (least > limit) return limit + 1;
  }
  return rows[a.size() % 3][b.size()];
}

}  // namespace

void NearestName::add(std::string_view candidate) {
  if (candidate.size() > 2 * kLongest) return;
  std::string letters = letters_of(candidate);
  if (letters.empty() || letters.size() > kLongest) return;
  const uint64_t which = letters_in(letters);
  candidates_.push_back({std::string(candidate), std::move(letters), which});
}

std::optional<std::string> NearestName::find(std::string_view wanted, uint64_t& steps) const {
  if (wanted.size() > 2 * kLongest) return std::nullopt;
  const std::string letters = letters_of(wanted);
  if (letters.size() > kLongest) return std::nullopt;
  const std::string lower = lower_case(letters);
  const uint64_t which = letters_in(letters);
  // In halves of an edit: equal letters cost nothing, another case one half.
  size_t least = 2 * most_edits(letters) + 1;
  const Candidate* nearest = nullptr;
  const auto offer = [&](const Candidate& candidate, size_t cost) {
    if (cost > least || (nearest != nullptr && cost == least)) return;
    least = cost;
    nearest = &candidate;
  };
  for (const Candidate& candidate : candidates_) {
    const bool is_near = least_distance(which, candidate.which) <= least / 2;
    const uint64_t work = is_near ? 1 + letters.size() * candidate.letters.size() : 1;
    if (work > steps) return std::nullopt;
    steps -= work;
    if (candidate.spelling == wanted) continue;
    const bool differs_in_case = candidate.letters.size() == letters.size() && candidate.letters != letters &&
                                 lower_case(candidate.letters) == lower;
    if (differs_in_case) {
      offer(candidate, 1);
    } else if (is_near) {
      offer(candidate, 2 * edit_distance(letters, candidate.letters, least / 2));
    }
  }
  if (nearest == nullptr) return std::nullopt;
  return nearest->spelling;
}

}  // namespace texbrdf
