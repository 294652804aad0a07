#include "analysis/settle_factors.h"

#include <algorithm>

#include "source/shared_pool.h"

namespace texbrdf {
namespace {

/// In order, each once.
std::vector<NameId> mentioned_in(const AnalysedBlock& block) {
  std::vector<NameId> names(block.mentions.begin(), block.mentions.end());
  std::ranges::sort(names);
  const auto repeated = std::ranges::unique(names);
  names.erase(repeated.begin(), repeated.end());
  return names;
}

class FactorUpdate {
 public:
  FactorUpdate(EngineState& state, WorkingBlocks& blocks, Counters& counters)
      : state_(state), blocks_(blocks), counters_(counters) {}

  void run(const ChangedNames& names) {
    std::vector<BlockLabel> users;
    for (NameId name : names.to_check) {
      NameKind& known = state_.name_states[name.value].kind;
      const NameKind now = kind_of(name);
      if (known == now) continue;
      known = now;
      state_.occurrences[name.value].users.visit_from(0, [&](const UserKey& user, const UserKey&) {
        users.push_back(user.block);
        return true;
      });
    }
    for (const WorkingBlock& block : blocks_.all()) users.push_back(block.label);
    std::ranges::sort(users);
    const auto repeated = std::ranges::unique(users);
    users.erase(repeated.begin(), repeated.end());
    for (BlockLabel label : users) settle(label);
    // A reading that was dropped may have met names that no other block has.
    state_.occurrences.resize(state_.names->size());
    state_.name_states.resize(state_.names->size());
  }

 private:
  NameKind kind_of(NameId name) const {
    const std::optional<DefinitionKey> key = state_.in_force(name);
    if (!key) return NameKind::Absent;
    const NamedDefinition& definition = blocks_.analysed(key->block)->definitions[key->index_in_block];
    return definition.left == definition.name_node ? NameKind::Value : NameKind::Function;
  }

  void settle(BlockLabel label) {
    const AnalysedBlock& block = *blocks_.analysed(label);
    const std::vector<uint32_t> factors = find_factors(
        block.parsed, block.names, *state_.names, [this](NameId name) { return state_.name_states[name.value].kind; });
    if (std::ranges::equal(factors, block.parsed.factors)) return;
    std::shared_ptr<const AnalysedBlock> again = read(block, factors);
    if (mentioned_in(*again) != mentioned_in(block)) {
      if (block.parsed.factors.empty()) return;
      again = read(block, {});
    }
    if (blocks_.find(label) == nullptr) ++state_.rereadings;
    WorkingBlock& working = blocks_.open(label);
    working.analysed = std::move(again);
    for (PlacedDefinition& definition : working.definitions) definition.record = nullptr;
  }

  /// Brackets that do not match may leave other names in a block that is read with factors. Who mentions what is listed
  /// by now: such a block stays as it is read without.
  std::shared_ptr<const AnalysedBlock> read(const AnalysedBlock& block, std::span<const uint32_t> factors) {
    ++counters_.blocks_parsed;
    return read_again_.make(analyse_block(block.parsed.text, block.parsed.extent, *state_.names, read_again_.memory(),
                                          read_again_.dense_memory(), factors));
  }

  EngineState& state_;
  WorkingBlocks& blocks_;
  Counters& counters_;
  SharedPool<AnalysedBlock> read_again_{1};
};

}  // namespace

void settle_factors(EngineState& state, WorkingBlocks& blocks, const ChangedNames& names, Counters& counters) {
  FactorUpdate(state, blocks, counters).run(names);
}

}  // namespace texbrdf
