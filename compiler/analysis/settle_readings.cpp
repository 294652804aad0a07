#include "analysis/settle_readings.h"

#include <algorithm>

#include "semantics/find_reading.h"
#include "semantics/implied_mentions.h"
#include "source/shared_pool.h"

namespace texbrdf {
namespace {

using AnalysedPointer = std::shared_ptr<const AnalysedBlock>;

class StatedNames final : public KnownNames {
 public:
  explicit StatedNames(const std::vector<NameState>& states) : states_(states) {}

  NameKind kind(NameId name) const override {
    return name.value < states_.size() ? states_[name.value].kind : NameKind::Absent;
  }
  std::span<const NameId> parameters(NameId function) const override { return states_[function.value].parameters; }

 private:
  const std::vector<NameState>& states_;
};

/// Reading again can change what a block mentions, never what it defines: else it stays as it is read by itself.
bool define_the_same(const AnalysedBlock& a, const AnalysedBlock& b) {
  return std::ranges::equal(a.definitions, b.definitions, {}, &NamedDefinition::name, &NamedDefinition::name);
}

class ReadingUpdate {
 public:
  ReadingUpdate(EngineState& state, WorkingBlocks& blocks, Counters& counters)
      : state_(state), blocks_(blocks), counters_(counters) {}

  void run(ChangedNames& names) {
    std::vector<BlockLabel> affected = users_of_changed(names);
    for (const WorkingBlock& block : blocks_.all()) affected.push_back(block.label);
    std::ranges::sort(affected);
    const auto repeated = std::ranges::unique(affected);
    affected.erase(repeated.begin(), repeated.end());
    for (BlockLabel label : affected) settle(label);
    names.to_check.insert(names.to_check.end(), recounted_.begin(), recounted_.end());
    add_changed_names(state_, changes_, names);
  }

 private:
  std::vector<BlockLabel> users_of_changed(const ChangedNames& names) {
    std::vector<BlockLabel> users;
    bool any_changed = false;
    for (NameId name : names.to_check) {
      if (!change_kind(name)) continue;
      any_changed = true;
      state_.occurrences[name.value].users.visit_from(0, [&](const UserKey& user, const UserKey&) {
        users.push_back(user.block);
        return true;
      });
    }
    if (any_changed) users.insert(users.end(), state_.open_words.begin(), state_.open_words.end());
    return users;
  }

  /// Whether others now see something else in the name.
  bool change_kind(NameId name) {
    NameKind kind = NameKind::Absent;
    std::vector<NameId> parameters;
    if (const std::optional<DefinitionKey> key = state_.in_force(name)) {
      const AnalysedBlock& block = *blocks_.analysed(key->block);
      const DefinitionSyntax& definition = block.parsed.definitions[key->index_in_block];
      kind = definition.left == definition.name ? NameKind::Value : NameKind::Function;
      parameters = parameter_names(block.parsed, definition, block.names);
    }
    NameState& known = state_.name_states[name.value];
    if (known.kind == kind && known.parameters == parameters) return false;
    known.kind = kind;
    count_parameters(known.parameters, -1);
    count_parameters(parameters, 1);
    known.parameters = std::move(parameters);
    return true;
  }

  void count_parameters(std::span<const NameId> parameters, int change) {
    for (const NameId name : parameters) {
      if (!name.valid()) continue;
      uint32_t& uses = state_.name_states[name.value].uses_as_parameter;
      const bool was_used = uses > 0;
      uses += static_cast<uint32_t>(change);
      if (was_used != (uses > 0)) recounted_.push_back(name);
    }
  }

  void settle(BlockLabel label) {
    const AnalysedPointer block = analysed(label);
    if (block == nullptr) {
      state_.open_words.erase(label);
      return;
    }
    const AnalysedPointer settled = settled_reading(label, block);
    if (settled == block) return;
    if (!is_new(label)) ++state_.rereadings;
    WorkingBlock& working = blocks_.open(label);
    working.analysed = settled;
    for (PlacedDefinition& definition : working.definitions) definition.record = nullptr;
    replaced_.push_back(block);
    changes_.push_back({label, block.get(), settled.get()});
  }

  /// Nobody has seen it before this update.
  bool is_new(BlockLabel label) const {
    const WorkingBlock* const working = blocks_.find(label);
    return working != nullptr &&
           std::ranges::none_of(working->definitions, [](const PlacedDefinition& d) { return d.record != nullptr; });
  }

  AnalysedPointer analysed(BlockLabel label) const {
    if (const WorkingBlock* working = blocks_.find(label)) return working->analysed;
    const auto place = find_block(state_.segments, label);
    return place.item == nullptr ? nullptr : place.item->block->analysed;
  }

  /// Depends on the bytes of the block and on what the document makes of names, not on how it was read before.
  AnalysedPointer settled_reading(BlockLabel label, const AnalysedPointer& block) {
    const AnalysedPointer plain = block->parsed.reading == Reading{} ? block : read(*block, {}, {});
    FoundReading found = find_reading(plain->parsed, plain->names, *state_.names, known_);
    note_open_words(label, found.has_open_words);
    AnalysedPointer settled = plain;
    if (found.reading != Reading{}) settled = read(*block, std::move(found.reading), {});
    if (!define_the_same(*settled, *plain)) settled = plain;
    return with_implied(block, settled, found.cut_names);
  }

  AnalysedPointer with_implied(const AnalysedPointer& block, const AnalysedPointer& settled,
                               const std::vector<NameId>& cut_names) {
    ImpliedMentions implied;
    const auto add = [&](uint32_t definition, const std::vector<NameId>& names) {
      if (names.empty()) return;
      implied.resize(settled->definitions.size());
      implied[definition].insert(implied[definition].end(), names.begin(), names.end());
    };
    for (uint32_t i = 0; i < settled->definitions.size(); ++i) {
      add(i, implied_mentions(settled->parsed, settled->parsed.definitions[i], settled->names, *state_.names, known_));
    }
    if (!settled->definitions.empty()) add(0, cut_names);
    if (block->parsed.reading == settled->parsed.reading && block->implied == implied) return block;
    return settled->implied == implied ? settled : read(*block, settled->parsed.reading, std::move(implied));
  }

  void note_open_words(BlockLabel label, bool has_open_words) {
    if (has_open_words) {
      state_.open_words.insert(label);
    } else if (!state_.open_words.empty()) {
      state_.open_words.erase(label);
    }
  }

  AnalysedPointer read(const AnalysedBlock& block, Reading reading, ImpliedMentions implied) {
    ++counters_.blocks_parsed;
    return read_again_.make(analyse_block(block.parsed.source(), block.parsed.source_extent(), *state_.names,
                                          read_again_.memory(), read_again_.dense_memory(), block.parsed.expansion,
                                          std::move(reading), std::move(implied)));
  }

  EngineState& state_;
  WorkingBlocks& blocks_;
  Counters& counters_;
  StatedNames known_{state_.name_states};
  SharedPool<AnalysedBlock> read_again_{1};
  std::vector<AnalysedPointer> replaced_;  // what changes_ point to
  std::vector<BlockChange> changes_;
  std::vector<NameId> recounted_;  // those that functions now call a parameter so, or no longer do
};

}  // namespace

void settle_readings(EngineState& state, WorkingBlocks& blocks, ChangedNames& names, Counters& counters) {
  ReadingUpdate(state, blocks, counters).run(names);
}

}  // namespace texbrdf
