#include "analysis/settle_factors.h"

#include <algorithm>

#include "source/shared_pool.h"

namespace texbrdf {
namespace {

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
    ++counters_.blocks_parsed;
    if (blocks_.find(label) == nullptr) ++state_.rereadings;
    WorkingBlock& working = blocks_.open(label);
    working.analysed = read_again_.make(analyse_block(block.parsed.text, block.parsed.extent, *state_.names,
                                                      read_again_.memory(), read_again_.dense_memory(), factors));
    for (PlacedDefinition& definition : working.definitions) definition.record = nullptr;
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
