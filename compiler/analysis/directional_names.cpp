#include "analysis/directional_names.h"

#include <algorithm>
#include <utility>

#include "analysis/engine_state.h"

namespace texbrdf {
namespace {

bool is_defined(const NameState& name) {
  return name.fact.kind == NameFact::Kind::Defined;
}

bool is_as_known(const EngineState& state, NameId name) {
  const NameState& own = state.name_states[name.value];
  const auto is_known = [&](NameId id) { return state.directional.contains(id, *state.names); };
  const bool is_now = is_defined(own) ? !own.in_knot && std::ranges::any_of(own.mentions, is_known)
                                      : state.names->traits(name).is_directional();
  return is_now == is_known(name);
}

/// Finds all directional names in one walk.
class Search {
 public:
  explicit Search(const EngineState& state)
      : states_(state.name_states), is_visited_(states_.size()), is_directional_(states_.size()) {
    for (uint32_t name = 0; name < states_.size(); ++name) {
      is_visited_[name] = !is_defined(states_[name]) || states_[name].in_knot;
      is_directional_[name] = !is_defined(states_[name]) && state.names->traits({name}).is_directional();
    }
  }

  std::vector<bool> run() {
    for (uint32_t name = 0; name < states_.size(); ++name) {
      if (!is_visited_[name]) visit({name});
    }
    return std::move(is_directional_);
  }

 private:
  struct Step {
    NameId name;
    size_t next_mention = 0;
  };

  void visit(NameId from) {
    path_.clear();
    enter(from);
    while (!path_.empty()) {
      Step& step = path_.back();
      const std::vector<NameId>& mentions = states_[step.name.value].mentions;
      if (step.next_mention == mentions.size()) {
        path_.pop_back();
        continue;
      }
      const NameId name = mentions[step.next_mention++];
      if (is_directional_[name.value]) {
        for (const Step& user : path_) is_directional_[user.name.value] = true;
        return;
      }
      if (!is_visited_[name.value]) enter(name);
    }
  }

  void enter(NameId name) {
    is_visited_[name.value] = true;
    path_.push_back({name});
  }

  const std::vector<NameState>& states_;
  std::vector<bool> is_visited_;
  std::vector<bool> is_directional_;
  std::vector<Step> path_;  // each mentions the next
};

}  // namespace

void update_directional(EngineState& state, const std::vector<NameId>& changed) {
  // Without knots what is known of all names follows from their mentions: where each is as its mentions say, all are.
  const auto is_right = [&](NameId name) { return is_as_known(state, name); };
  const bool may_stay = state.cycles->empty() || changed.empty();
  if (may_stay && std::ranges::all_of(changed, is_right)) return;
  state.directional = DirectionalNames(Search(state).run());
}

}  // namespace texbrdf
