#include "features/name_index.h"

#include <algorithm>

#include "source/characters.h"
#include "syntax/control_words.h"

namespace texbrdf::features {
namespace {

/// Longer names are typed by nobody.
constexpr std::size_t kLongestName = 200;
/// So many are put in one by one; of more, all are sorted.
constexpr std::size_t kFewNames = 32;

/// "\vec" or "\text" for a spelling of them that stands in front with a brace behind it, which is taken off; else
/// empty.
std::string_view take_decoration(std::string_view& spelling) {
  if (!spelling.starts_with('\\')) return {};
  std::size_t end = 1;
  while (end < spelling.size() && is_letter(spelling[end])) ++end;
  const WordMeaning meaning = find_control_word(spelling.substr(1, end - 1)).meaning;
  const bool is_decoration = meaning == WordMeaning::Vec || meaning == WordMeaning::Text;
  if (!is_decoration || end == spelling.size() || spelling[end] != '{') return {};
  spelling.remove_prefix(end + 1);
  return meaning == WordMeaning::Vec ? "\\vec" : "\\text";
}

/// The length of a `\text{` in front.
std::size_t text_command_length(std::string_view spelling) {
  std::string_view behind = spelling;
  return take_decoration(behind) == "\\text" ? spelling.size() - behind.size() : 0;
}

/// Upright letters inside of a name are letters like others.
void append_folded(std::string& key, std::string_view spelling) {
  for (std::size_t i = 0; i < spelling.size(); ++i) {
    if (spelling[i] == '\\') i += text_command_length(spelling.substr(i));
    if (i >= spelling.size()) return;
    const char c = spelling[i];
    const bool is_layout = c == '\\' || c == '{' || c == '}' || c == ' ' || c == '\t' || c == '&';
    if (!is_layout) key += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
}

}  // namespace

std::string search_key(std::string_view spelling) {
  std::string key(take_decoration(spelling));
  if (spelling.starts_with('\\') && key.empty()) key += '\\';
  append_folded(key, spelling);
  return key;
}

std::string bare_search_key(std::string_view spelling) {
  while (!take_decoration(spelling).empty()) {
  }
  std::string key;
  append_folded(key, spelling);
  return key;
}

bool starts_with_key(std::string_view name, std::string_view key) {
  return key.empty() || (key.starts_with('\\') ? search_key(name) : bare_search_key(name)).starts_with(key);
}

void NameIndex::update(const std::shared_ptr<const NameTable>& table) {
  if (table_.lock() != table) {
    *this = {};
    table_ = table;
  }
  const std::size_t sorted = entries_.size();
  for (; known_ < table->size(); ++known_) {
    const NameId name{known_};
    const std::string_view text = table->text(name);
    if (text.size() > kLongestName) continue;
    add(bare_search_key(text), name);
    if (text.starts_with('\\')) add(search_key(text), name);
  }
  if (entries_.size() > sorted) sort_added(sorted);
}

void NameIndex::add(std::string_view key, NameId name) {
  entries_.push_back({static_cast<uint32_t>(keys_.size()), static_cast<uint32_t>(key.size()), name});
  keys_ += key;
}

void NameIndex::sort_added(std::size_t first) {
  const auto before = [this](const Entry& a, const Entry& b) { return key(a) < key(b); };
  if (entries_.size() - first > kFewNames) {
    std::stable_sort(entries_.begin(), entries_.end(), before);
    return;
  }
  for (auto added = entries_.begin() + static_cast<std::ptrdiff_t>(first); added != entries_.end(); ++added) {
    std::rotate(std::upper_bound(entries_.begin(), added, *added, before), added, added + 1);
  }
}

NameIndex::Matches NameIndex::starting_with(std::string_view wanted, std::size_t most) const {
  const auto front = [this, wanted](const Entry& entry) { return key(entry).substr(0, wanted.size()); };
  Matches matches;
  for (const Entry& entry : std::ranges::equal_range(entries_, wanted, {}, front)) {
    const bool is_second = wanted.empty() && key(entry).starts_with('\\');
    if (is_second) continue;
    matches.complete = matches.names.size() < most;
    if (!matches.complete) break;
    matches.names.push_back(entry.name);
  }
  return matches;
}

}  // namespace texbrdf::features
