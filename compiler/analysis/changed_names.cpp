#include "analysis/changed_names.h"

#include <algorithm>
#include <iterator>

namespace texbrdf {
namespace {

void make_unique(std::vector<NameId>& names) {
  if (!std::ranges::is_sorted(names)) std::ranges::sort(names);
  const auto repeated = std::ranges::unique(names);
  names.erase(repeated.begin(), repeated.end());
}

void make_unique(ChangedNames& names) {
  make_unique(names.listed);
  make_unique(names.to_check);
  make_unique(names.reordered);
  make_unique(names.mentioned);
}

void append(std::vector<NameId>& to, const std::vector<NameId>& names) {
  to.insert(to.end(), names.begin(), names.end());
}

std::vector<NameId> mentions_of(const AnalysedBlock* block) {
  if (block == nullptr) return {};
  std::vector<NameId> names(block->mentions.begin(), block->mentions.end());
  make_unique(names);
  return names;
}

size_t definition_count(const AnalysedBlock* block) {
  return block == nullptr ? 0 : block->definitions.size();
}

class NameUpdate {
 public:
  NameUpdate(EngineState& state, bool all_new) : state_(state), is_all_new_(all_new) {}

  ChangedNames run(const std::vector<BlockChange>& changes) {
    if (is_all_new_) reserve(changes.size());
    lists_changed_ = !state_.lists_users && !is_all_new_;
    if (lists_changed_) list_users(state_);
    for (const BlockChange& change : changes) {
      if (change.before == change.after && !lists_changed_) continue;
      update_definitions(change);
      if (!is_all_new_) update_mentions(change);
    }
    make_unique(names_);
    return std::move(names_);
  }

 private:
  void reserve(size_t blocks) {
    single_keys_ = Sequence<DefinitionKey>::Pool(blocks);
    names_.listed.reserve(blocks);
    names_.to_check.reserve(blocks);
    names_.reordered.reserve(blocks);
  }

  void update_definitions(const BlockChange& change) {
    const AnalysedBlock* before = change.before;
    const AnalysedBlock* after = change.after;
    const size_t count = std::max(definition_count(before), definition_count(after));
    for (uint32_t i = 0; i < count; ++i) {
      const NameId old_name = i < definition_count(before) ? before->defined(i) : NameId{};
      const NameId new_name = i < definition_count(after) ? after->defined(i) : NameId{};
      const DefinitionKey old_key{change.label, i, old_name.valid() ? before->standing(i) : Standing::Display};
      const DefinitionKey new_key{change.label, i, new_name.valid() ? after->standing(i) : Standing::Display};
      const bool has_moved = old_name != new_name || old_key.standing != new_key.standing;
      if (has_moved && old_name.valid()) erase_key(state_.occurrences[old_name.value].definitions, old_key);
      if (has_moved && new_name.valid()) insert_definition(new_name, new_key);
      note(old_name, has_moved);
      note(new_name, has_moved);
      if (has_moved || !std::ranges::equal(before->mentions_of(i), after->mentions_of(i))) {
        if (old_name.valid()) names_.reordered.push_back(old_name);
        if (new_name.valid()) names_.reordered.push_back(new_name);
      }
    }
  }

  void insert_definition(NameId name, const DefinitionKey& key) {
    Sequence<DefinitionKey>& definitions = state_.occurrences[name.value].definitions;
    if (definitions.empty()) {
      definitions = Sequence<DefinitionKey>(key, single_keys_);
    } else {
      insert_key(definitions, key);
    }
  }

  void note(NameId name, bool is_listed_elsewhere) {
    if (!name.valid()) return;
    names_.to_check.push_back(name);
    if (is_listed_elsewhere) names_.listed.push_back(name);
  }

  void update_mentions(const BlockChange& change) {
    const std::vector<NameId> before = mentions_of(change.before);
    const std::vector<NameId> after = mentions_of(change.after);
    if (lists_changed_) {
      // A block that is read again because of a macro was listed as it was read before.
      for (NameId name : before) erase_key(state_.occurrences[name.value].users, UserKey{change.label});
      for (NameId name : after) insert_key(state_.occurrences[name.value].users, UserKey{change.label});
    }
    if (before == after) return;
    std::vector<NameId> gone, come;
    std::ranges::set_difference(before, after, std::back_inserter(gone));
    std::ranges::set_difference(after, before, std::back_inserter(come));
    names_.mentioned.insert(names_.mentioned.end(), gone.begin(), gone.end());
    names_.mentioned.insert(names_.mentioned.end(), come.begin(), come.end());
    if (lists_changed_) return;
    for (NameId name : gone) erase_key(state_.occurrences[name.value].users, UserKey{change.label});
    for (NameId name : come) insert_key(state_.occurrences[name.value].users, UserKey{change.label});
  }

  EngineState& state_;
  const bool is_all_new_;
  bool lists_changed_ = false;  // the changed blocks are in no list yet
  Sequence<DefinitionKey>::Pool single_keys_{1};
  ChangedNames names_;
};

}  // namespace

void list_users(EngineState& state) {
  std::vector<std::vector<UserKey>> users(state.occurrences.size());
  state.segments.visit_from(0, [&](const Segment& segment, const Segment::Measure&) {
    if (!segment.block || !segment.block->analysed) return true;
    for (NameId name : segment.block->analysed->mentions) {
      const bool is_listed = !users[name.value].empty() && users[name.value].back().block == segment.block->label;
      if (!is_listed) users[name.value].push_back({segment.block->label});
    }
    return true;
  });
  for (size_t name = 0; name < users.size(); ++name)
    state.occurrences[name].users = Sequence<UserKey>(std::move(users[name]));
  state.lists_users = true;
}

ChangedNames update_names(EngineState& state, const std::vector<BlockChange>& changes, bool all_new) {
  state.occurrences.resize(state.names->size());
  state.name_states.resize(state.names->size());
  return NameUpdate(state, all_new).run(changes);
}

void add_changed_names(EngineState& state, const std::vector<BlockChange>& changes, ChangedNames& names) {
  state.occurrences.resize(state.names->size());
  state.name_states.resize(state.names->size());
  if (changes.empty()) return make_unique(names.to_check);
  const ChangedNames more = NameUpdate(state, !state.lists_users).run(changes);
  append(names.listed, more.listed);
  append(names.to_check, more.to_check);
  append(names.reordered, more.reordered);
  append(names.mentioned, more.mentioned);
  make_unique(names);
}

}  // namespace texbrdf
