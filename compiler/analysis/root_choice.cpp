#include "analysis/root_choice.h"

#include <algorithm>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace texbrdf {
namespace {

/// Of more definitions that may be the root, only the first are looked at.
constexpr size_t kMaxCandidates = 64;

class RootSearch {
 public:
  explicit RootSearch(EngineState& state) : state_(state) {}

  RootChoice run() {
    read_directives();
    if (choice_.name.empty()) {
      if (const std::optional<NameId> best = best_candidate()) choice_.name = state_.names->text(*best);
    }
    return std::move(choice_);
  }

 private:
  void read_directives() {
    state_.segments.visit_where([](const Segment::Measure& sum) { return sum.directives > 0; },
                                [&](const Segment& segment, const Segment::Measure&) {
                                  read(directives_of(segment));
                                  return true;
                                });
  }

  void read(std::span<const Directive> directives) {
    choice_.has_directives = true;
    for (const Directive& directive : directives) {
      if (directive.kind == Directive::Kind::Root && choice_.name.empty()) choice_.name = root_of(directive);
    }
  }

  /// A definition that may be the root.
  struct Candidate {
    NameId name;
    const CheckedDefinition* checked;
    std::span<const NameId> mentions;
  };

  /// A function of two vectors, or of what has a meaning outside of it.
  bool has_shape(const Candidate& candidate) const {
    const auto has_meaning = [&](const CheckedParameter& parameter) {
      return parameter.name.valid() &&
             (state_.names->traits(parameter.name).meaning() || state_.in_force(parameter.name));
    };
    return has_brdf_parameters(candidate.checked->signature) ||
           std::ranges::all_of(candidate.checked->parameters, has_meaning);
  }

  std::vector<Candidate> candidates() const {
    std::vector<Candidate> found;
    state_.segments.visit_where([](const Segment::Measure& sum) { return sum.candidates > 0; },
                                [&](const Segment& segment, const Segment::Measure&) {
                                  add_candidates(*segment.block, found);
                                  return found.size() < kMaxCandidates;
                                });
    return found;
  }

  void add_candidates(const PlacedBlock& block, std::vector<Candidate>& found) const {
    for (uint32_t i = 0; i < block.definitions.size(); ++i) {
      const NameId name = block.analysed->defined(i);
      const PlacedDefinition& definition = block.definitions[i];
      if (!definition.in_force || !state_.names->traits(name).may_be_brdf) continue;
      found.push_back({name, &definition.record->checked, block.analysed->mentions_of(i)});
    }
  }

  std::optional<NameId> best_candidate() const {
    std::vector<Candidate> all = candidates();
    const auto is_shaped = [&](const Candidate& candidate) { return has_shape(candidate); };
    if (std::ranges::any_of(all, is_shaped)) std::erase_if(all, std::not_fn(is_shaped));
    const auto is_constant = [&](const Candidate& candidate) { return !is_directional(candidate); };
    if (!std::ranges::all_of(all, is_constant)) std::erase_if(all, is_constant);
    const Candidate* best = nullptr;
    for (const Candidate& candidate : all) {
      const bool is_used = std::ranges::any_of(all, [&](const Candidate& user) {
        return user.name != candidate.name && std::ranges::find(user.mentions, candidate.name) != user.mentions.end();
      });
      if (!is_used && (best == nullptr || rank(candidate) < rank(*best))) best = &candidate;
    }
    return best == nullptr ? std::nullopt : std::optional(best->name);
  }

  bool is_directional(const Candidate& candidate) const {
    const auto changes = [&](NameId name) { return state_.directional.contains(name, *state_.names); };
    const auto is_angle = [&](const CheckedParameter& parameter) {
      return parameter.name.valid() && state_.names->traits(parameter.name).is_directional();
    };
    return std::ranges::any_of(candidate.mentions, changes) ||
           std::ranges::any_of(candidate.checked->signature.parameters, is_triple) ||
           std::ranges::any_of(candidate.checked->parameters, is_angle);
  }

  // One that mentions more is nearer to the whole; else `f` itself, else the first of the document.
  std::pair<int64_t, bool> rank(const Candidate& candidate) const {
    return {-static_cast<int64_t>(candidate.mentions.size()), state_.names->text(candidate.name) != "f"};
  }

  const EngineState& state_;
  RootChoice choice_;
};

}  // namespace

void choose_root(EngineState& state) {
  state.root = RootSearch(state).run();
}

}  // namespace texbrdf
