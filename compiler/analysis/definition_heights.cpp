#include "analysis/definition_heights.h"

#include <algorithm>

#include "semantics/dependency_order.h"

namespace texbrdf {
namespace {

/// Lifting is given up where it takes longer than putting everything in order.
constexpr size_t kLeastSteps = 1000;

class Lift {
 public:
  Lift(EngineState& state, const WorkingBlocks& blocks)
      : state_(state), blocks_(blocks), steps_left_(std::max(kLeastSteps, state.names->size() / size_t{4})) {}

  /// False where it was given up: then some definition may need itself.
  bool run(const std::vector<NameId>& names) {
    for (NameId name : names) {
      const std::optional<DefinitionKey> key = state_.in_force(name);
      if (!key) {
        height(name) = 0;
      } else if (!lift(name, 1 + highest_mention(*key))) {
        return false;
      }
    }
    return true;
  }

 private:
  uint32_t& height(NameId name) { return state_.name_states[name.value].height; }

  uint32_t highest_mention(const DefinitionKey& key) {
    uint32_t highest = 0;
    for (NameId name : blocks_.analysed(key.block)->mentions_of(key.index_in_block)) {
      highest = std::max(highest, height(name));
    }
    return highest;
  }

  bool lift(NameId name, uint32_t least) {
    if (height(name) >= least) return true;
    height(name) = least;
    std::vector<NameId> lifted = {name};
    while (!lifted.empty()) {
      const NameId low = lifted.back();
      lifted.pop_back();
      bool has_time = true;
      state_.occurrences[low.value].users.visit_from(0, [&](const UserKey& user, const UserKey&) {
        has_time = lift_users(*blocks_.analysed(user.block), user.block, low, lifted);
        return has_time;
      });
      if (!has_time) return false;
    }
    return true;
  }

  bool lift_users(const AnalysedBlock& block, BlockLabel label, NameId low, std::vector<NameId>& lifted) {
    for (uint32_t i = 0; i < block.parsed.definitions.size(); ++i) {
      if (steps_left_-- == 0) return false;
      const NameId user = block.defined(i);
      if (height(user) > height(low) || state_.in_force(user) != DefinitionKey{label, i}) continue;
      if (std::ranges::find(block.mentions_of(i), low) == block.mentions_of(i).end()) continue;
      height(user) = height(low) + 1;
      lifted.push_back(user);
    }
    return true;
  }

  EngineState& state_;
  const WorkingBlocks& blocks_;
  size_t steps_left_;
};

/// Puts all definitions in order.
class FullOrder {
 public:
  FullOrder(EngineState& state, const WorkingBlocks& blocks) : state_(state), blocks_(blocks) {}

  OrderChange run() {
    list_definitions();
    list_edges();
    const DependencyOrder order = dependency_order(edges_);
    for (NameState& name : state_.name_states) name.height = 0;
    for (uint32_t index : order.order) set_height(index);
    note_cycles(order);
    return {.knotted = change_knots(order), .order = names_of(order.order)};
  }

 private:
  struct Defined {
    NameId name;
    const AnalysedBlock* block;
    uint32_t index_in_block;
  };

  void list_definitions() {
    places_.assign(state_.name_states.size(), UINT32_MAX);
    definitions_.reserve(state_.name_states.size());
    state_.segments.visit_from(0, [&](const Segment& segment, const Segment::Measure&) {
      if (!segment.block) return true;
      const BlockLabel label = segment.block->label;
      const AnalysedBlock* block = segment.block->analysed.get();
      if (const WorkingBlock* working = blocks_.find(label)) block = working->analysed.get();
      for (uint32_t i = 0; i < block->parsed.definitions.size(); ++i) {
        const NameId name = block->defined(i);
        if (state_.in_force(name) != DefinitionKey{label, i}) continue;
        places_[name.value] = static_cast<uint32_t>(definitions_.size());
        definitions_.push_back({name, block, i});
      }
      return true;
    });
  }

  void list_edges() {
    edges_.starts.reserve(definitions_.size() + 1);
    for (const Defined& definition : definitions_) {
      for (NameId name : definition.block->mentions_of(definition.index_in_block)) {
        if (places_[name.value] != UINT32_MAX) edges_.targets.push_back(places_[name.value]);
      }
      edges_.close_list();
    }
  }

  NameState& name_state(uint32_t index) { return state_.name_states[definitions_[index].name.value]; }

  void set_height(uint32_t index) {
    uint32_t highest = 0;
    for (uint32_t target : edges_.of(index)) highest = std::max(highest, name_state(target).height);
    name_state(index).height = highest + 1;
  }

  std::vector<NameId> names_of(const std::vector<uint32_t>& indices) const {
    std::vector<NameId> names;
    names.reserve(indices.size());
    for (uint32_t index : indices) names.push_back(definitions_[index].name);
    return names;
  }

  void note_cycles(const DependencyOrder& order) {
    std::vector<Cycle> cycles;
    for (const std::vector<uint32_t>& path : order.cycles) {
      Cycle& cycle = cycles.emplace_back();
      for (uint32_t index : path) cycle.push_back(definitions_[index].name);
    }
    state_.cycles = std::make_shared<const std::vector<Cycle>>(std::move(cycles));
  }

  std::vector<NameId> change_knots(const DependencyOrder& order) {
    std::vector<bool> in_knot(state_.name_states.size());
    for (const std::vector<uint32_t>& knot : order.knots) {
      for (uint32_t index : knot) in_knot[definitions_[index].name.value] = true;
    }
    std::vector<NameId> changed;
    for (uint32_t name = 0; name < in_knot.size(); ++name) {
      if (state_.name_states[name].in_knot == in_knot[name]) continue;
      state_.name_states[name].in_knot = in_knot[name];
      changed.push_back(NameId{name});
    }
    return changed;
  }

  EngineState& state_;
  const WorkingBlocks& blocks_;
  std::vector<Defined> definitions_;  // those in force, in document order
  std::vector<uint32_t> places_;      // by NameId, in `definitions_`
  AdjacencyLists edges_;
};

}  // namespace

OrderChange order_definitions(EngineState& state, const WorkingBlocks& blocks, const std::vector<NameId>& reordered) {
  if (reordered.empty()) return {};
  const bool may_lift = state.lists_users && state.cycles->empty();
  if (may_lift && Lift(state, blocks).run(reordered)) return {};
  return FullOrder(state, blocks).run();
}

}  // namespace texbrdf
