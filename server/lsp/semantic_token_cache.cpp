#include "lsp/semantic_token_cache.h"

#include <algorithm>
#include <iterator>
#include <unordered_map>

#include "lsp/block_splice.h"
#include "lsp/positions.h"

namespace texbrdf::lsp {
namespace {

using Entry = SemanticTokenCache::Entry;
using Entries = std::span<const Entry>;

Position begin_of(const Snapshot& snapshot, Positions& positions, uint32_t block) {
  return positions.at(snapshot.absolute(BlockId{block}, {}).begin);
}

/// With a comma behind each.
void append(std::string& out, Entries entries) {
  for (const Entry& entry : entries) {
    if (entry.count == 0) continue;
    append_place(out, entry.lead);
    out += ',';
    out += entry.run->numbers;
    out += ',';
  }
}

void drop_last_comma(std::string& json) {
  if (json.ends_with(',')) json.pop_back();
}

uint64_t numbers_of(Entries entries) {
  uint64_t tokens = 0;
  for (const Entry& entry : entries) tokens += entry.count;
  return tokens * kNumbersPerToken;
}

std::size_t same_at_front(Entries a, Entries b) {
  const auto [in_a, in_b] = std::ranges::mismatch(a, b, [](const Entry& x, const Entry& y) { return x.is_same(y); });
  return static_cast<std::size_t>(in_a - a.begin());
}

std::size_t same_at_back(Entries a, Entries b) {
  std::size_t count = 0;
  while (count < std::min(a.size(), b.size()) && a[a.size() - 1 - count].is_same(b[b.size() - 1 - count])) ++count;
  return count;
}

}  // namespace

SemanticTokenCache::Change SemanticTokenCache::update(const Snapshot& snapshot, ColumnUnit unit, uint64_t result_id) {
  const features::HiddenConventions hidden(snapshot);
  const bool comparable = shown_ && hidden_ == hidden && shown_->rereadings() == snapshot.rereadings();
  const BlockSplice splice = comparable ? find_splice(*shown_, snapshot, edited_)
                                        : BlockSplice{0, static_cast<uint32_t>(entries_.size()),
                                                      static_cast<uint32_t>(snapshot.blocks().size())};
  Change change{splice.first, {}, splice.after_end - splice.first, {}};
  const auto begin = entries_.begin() + splice.first;
  const auto end = entries_.begin() + splice.before_end;
  change.before.assign(begin, end);
  if (const auto behind = next_with_tokens(splice.before_end)) change.lead_behind_before = entries_[*behind].lead;

  hidden_ = hidden;
  std::vector<Entry> after =
      encode(snapshot, splice.first, splice.after_end, unit, comparable ? change.before : std::vector<Entry>{});
  if (after.size() == change.before.size()) {
    std::ranges::move(after, begin);
  } else {
    const auto at = entries_.erase(begin, end);
    entries_.insert(at, std::make_move_iterator(after.begin()), std::make_move_iterator(after.end()));
  }
  place_leads(snapshot, splice.first, splice.after_end, unit);
  shown_ = snapshot;
  edited_ = {};
  result_id_ = std::to_string(result_id);
  return change;
}

/// The blocks [first, end) of the snapshot, without leads. `reusable` are entries of `shown_` from `first` on.
std::vector<Entry> SemanticTokenCache::encode(const Snapshot& snapshot, uint32_t first, uint32_t end, ColumnUnit unit,
                                              const std::vector<Entry>& reusable) const {
  std::unordered_map<const ParsedBlock*, const Entry*> known;
  for (uint32_t i = 0; i < reusable.size(); ++i) known.emplace(&shown_->parsed(BlockId{first + i}), &reusable[i]);
  std::vector<Entry> entries;
  entries.reserve(end - first);
  for (uint32_t i = first; i < end; ++i) {
    const ParsedBlock& parsed = snapshot.parsed(BlockId{i});
    Entry& entry = entries.emplace_back();
    if (const auto found = known.find(&parsed); found != known.end()) {
      entry.run = found->second->run;
    } else {
      entry.run = std::make_shared<const TokenRun>(
          encode_run(parsed.source(), features::block_tokens(snapshot, BlockId{i}, *hidden_), unit));
    }
    entry.count = entry.run->count;
  }
  return entries;
}

/// For the entries [first, end), and for the next one that has tokens, since it is told from theirs.
void SemanticTokenCache::place_leads(const Snapshot& snapshot, uint32_t first, uint32_t end, ColumnUnit unit) {
  Positions positions(snapshot.text(), unit);
  Position last;
  if (const auto before = last_with_tokens_before(first)) {
    last = advanced(begin_of(snapshot, positions, *before), entries_[*before].run->last);
  }
  const auto behind = next_with_tokens(end);
  const uint32_t placed_end = behind ? *behind + 1 : end;
  for (uint32_t i = first; i < placed_end; ++i) {
    Entry& entry = entries_[i];
    if (entry.count == 0) continue;
    const Position begin = begin_of(snapshot, positions, i);
    entry.lead = distance(last, advanced(begin, entry.run->first));
    last = advanced(begin, entry.run->last);
  }
}

std::string SemanticTokenCache::data() const {
  constexpr std::size_t kLeadBytes = 8;  // most of them; only a guess
  std::size_t size = 2;
  for (const Entry& entry : entries_) size += entry.run->numbers.size() + kLeadBytes;
  std::string text;
  text.reserve(size);
  text += '[';
  append(text, entries_);
  drop_last_comma(text);
  text += ']';
  return text;
}

std::vector<SemanticTokenCache::Edit> SemanticTokenCache::edits(const Change& change) const {
  const Entries before = change.before;
  const Entries after = Entries(entries_).subspan(change.first, change.after_count);
  const std::size_t front = same_at_front(before, after);
  const std::size_t back = same_at_back(before.subspan(front), after.subspan(front));
  const Entries deleted = before.subspan(front, before.size() - front - back);
  const Entries inserted = after.subspan(front, after.size() - front - back);
  const uint64_t first = numbers_of(Entries(entries_).first(change.first));

  std::vector<Edit> edits;
  if (!deleted.empty() || !inserted.empty()) {
    Edit& edit = edits.emplace_back(Edit{first + numbers_of(before.first(front)), numbers_of(deleted), {}});
    append(edit.data, inserted);
    drop_last_comma(edit.data);
    if (edit.delete_count == 0 && edit.data.empty()) edits.pop_back();
  }
  const auto behind = next_with_tokens(change.first + change.after_count);
  if (behind && entries_[*behind].lead != change.lead_behind_before) {
    Edit& edit = edits.emplace_back(Edit{first + numbers_of(before), kNumbersPerPlace, {}});
    append_place(edit.data, entries_[*behind].lead);
  }
  return edits;
}

std::optional<uint32_t> SemanticTokenCache::next_with_tokens(uint32_t from) const {
  for (uint32_t i = from; i < entries_.size(); ++i) {
    if (entries_[i].count > 0) return i;
  }
  return std::nullopt;
}

std::optional<uint32_t> SemanticTokenCache::last_with_tokens_before(uint32_t end) const {
  for (uint32_t i = end; i > 0; --i) {
    if (entries_[i - 1].count > 0) return i - 1;
  }
  return std::nullopt;
}

}  // namespace texbrdf::lsp
