#include "analysis/check_changes.h"

#include <algorithm>
#include <queue>
#include <utility>

#include "semantics/implied_parameters.h"
#include "source/shared_pool.h"

namespace texbrdf {
namespace {

/// More instances than this are not checked again to see whether users have to be.
constexpr size_t kMostKeptInstances = 32;

class KnownFacts final : public InstanceFacts {
 public:
  KnownFacts(EngineState& state, const WorkingBlocks& blocks) : state_(state), blocks_(blocks) {}
  const NameFact& fact(NameId name) const override { return state_.name_states[name.value].fact; }

 private:
  std::optional<DefinitionView> definition(NameId function) const override {
    const std::optional<DefinitionKey> key = state_.in_force(function);
    if (!key || state_.name_states[function.value].in_knot) return std::nullopt;
    const AnalysedBlock& block = *blocks_.analysed(key->block);
    return DefinitionView{block.parsed, block.parsed.definitions[key->index_in_block], block.names, *state_.names,
                          *this};
  }
  InstancesOfFunction& known_instances(NameId function) const override {
    return state_.name_states[function.value].instances;
  }

  EngineState& state_;
  const WorkingBlocks& blocks_;
};

class CheckChanges {
 public:
  CheckChanges(EngineState& state, WorkingBlocks& blocks, Counters& counters)
      : state_(state), blocks_(blocks), counters_(counters), records_(blocks.all().size()) {}

  void run(const std::vector<NameId>& names) {
    is_queued_.resize(state_.name_states.size());
    for (NameId name : names) enqueue(name);
    while (!queue_.empty()) {
      const NameId name = queue_.top().name;
      queue_.pop();
      is_queued_[name.value] = false;
      settle(name);
    }
    check_rest();
  }

  void run_in_order(const std::vector<NameId>& order) {
    for (NameState& name : state_.name_states) name.fact.is_parameter = name.uses_as_parameter > 0;
    for (NameId name : order) {
      state_of(name).instances.clear();
      state_of(name).fact = fact_of(name);
    }
    check_rest();
  }

 private:
  // Definitions on which no other depends: later ones of a name, and those in knots.
  void check_rest() {
    for (const WorkingBlock& block : blocks_.all()) note_unchecked(block);
    for (const DefinitionKey& key : rest_) check(key);
  }

  struct Waiting {
    uint32_t height;
    NameId name;
    friend bool operator<(const Waiting& a, const Waiting& b) { return a.height > b.height; }  // lowest on top
  };

  NameState& state_of(NameId name) { return state_.name_states[name.value]; }

  void enqueue(NameId name) {
    if (is_queued_[name.value]) return;
    is_queued_[name.value] = true;
    // What a knot says of itself depends on its left side only.
    queue_.push({state_of(name).in_knot ? 0 : state_of(name).height, name});
  }

  void settle(NameId name) {
    NameFact now = fact_of(name);
    const InstancesOfFunction instances = std::exchange(state_of(name).instances, {});
    if (now == state_of(name).fact && are_same(name, instances)) return;
    state_of(name).fact = std::move(now);
    state_.occurrences[name.value].users.visit_from(0, [&](const UserKey& user, const UserKey&) {
      recheck_users(user.block, name);
      return true;
    });
  }

  /// Those below the name are settled: they can be found out about again.
  bool are_same(NameId name, const InstancesOfFunction& instances) const {
    if (instances.size() > kMostKeptInstances) return false;
    return std::ranges::all_of(instances,
                               [&](const auto& known) { return facts_.instance({name, known.first}) == known.second; });
  }

  NameFact fact_of(NameId name) {
    const std::optional<DefinitionKey> key = state_.in_force(name);
    if (!key) return absent(name);
    const std::vector<NameId>& parameters = state_of(name).parameters;
    if (state_of(name).in_knot) return {NameFact::Kind::Defined, poison(*key), parameters};
    const CheckedDefinition& checked = check(*key);
    if (checked.signature.has_implied_parameters) {
      return {NameFact::Kind::Defined, checked.signature, names_of_parameters(checked)};
    }
    return {NameFact::Kind::Defined, checked.signature, parameters};
  }

  NameFact absent(NameId name) {
    NameFact fact;
    fact.is_parameter = state_of(name).uses_as_parameter > 0;
    return fact;
  }

  // Definitions on a cycle have no types; what they take is known all the same.
  Signature poison(const DefinitionKey& key) const {
    const ParsedBlock& block = blocks_.analysed(key.block)->parsed;
    const Node& left = block.tree.node(block.definitions[key.index_in_block].left);
    Signature signature;
    signature.is_function = left.kind == NodeKind::Signature;
    if (signature.is_function) signature.parameters.assign(left.child_count - 1, Type::Error);
    return signature;
  }

  void recheck_users(BlockLabel label, NameId name) {
    const AnalysedBlock& block = *blocks_.analysed(label);
    for (uint32_t i = 0; i < block.parsed.definitions.size(); ++i) {
      if (std::ranges::find(block.mentions_of(i), name) == block.mentions_of(i).end()) continue;
      blocks_.open(label).definitions[i].record = nullptr;
      if (state_.in_force(block.defined(i)) == DefinitionKey{label, i}) enqueue(block.defined(i));
    }
  }

  const CheckedDefinition& check(const DefinitionKey& key) {
    WorkingBlock* const block = blocks_.find(key.block);
    if (block == nullptr) {
      const auto place = find_block(state_.segments, key.block);
      return place.item->block->definitions[key.index_in_block].record->checked;
    }
    std::shared_ptr<const DefinitionRecord>& record = block->definitions[key.index_in_block].record;
    if (record) return record->checked;
    ++counters_.definitions_checked;
    const AnalysedBlock& analysed = *block->analysed;
    record = records_.make(check_definition(analysed.parsed, analysed.parsed.definitions[key.index_in_block],
                                            analysed.names, *state_.names, facts_));
    return record->checked;
  }

  void note_unchecked(const WorkingBlock& block) {
    for (uint32_t i = 0; i < block.definitions.size(); ++i) {
      if (!block.definitions[i].record) rest_.push_back({block.label, i});
    }
  }

  EngineState& state_;
  WorkingBlocks& blocks_;
  Counters& counters_;
  const KnownFacts facts_{state_, blocks_};
  std::priority_queue<Waiting> queue_;
  std::vector<bool> is_queued_;  // by NameId
  std::vector<DefinitionKey> rest_;
  SharedPool<DefinitionRecord> records_;
};

}  // namespace

void check_changes(EngineState& state, WorkingBlocks& blocks, const std::vector<NameId>& names, Counters& counters) {
  CheckChanges(state, blocks, counters).run(names);
}

void check_all(EngineState& state, WorkingBlocks& blocks, const std::vector<NameId>& order, Counters& counters) {
  CheckChanges(state, blocks, counters).run_in_order(order);
}

}  // namespace texbrdf
