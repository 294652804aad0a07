#include "analysis/root_choice.h"

#include <algorithm>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "analysis/root_arguments.h"

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
    const CheckedDefinition& checked = *candidate.checked;
    if (has_brdf_parameters(checked.signature)) return true;
    for (uint32_t i = 0; i < checked.parameters.size(); ++i) {
      const NameId name = checked.parameters[i].name;
      const bool needs_none = !name.valid() || may_be_anything(checked.signature, i);
      if (!needs_none && !state_.names->traits(name).meaning() && !state_.in_force(name)) return false;
    }
    return true;
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
      const CheckedDefinition& checked = definition.record->checked;
      if (!definition.in_force || !is_root_candidate(state_.names->traits(name), checked)) continue;
      found.push_back({name, &checked, block.analysed->mentions_of(i)});
    }
  }

  std::optional<NameId> best_candidate() const {
    std::vector<Candidate> all = candidates();
    const auto may_be_albedo = [&](const Candidate& candidate) {
      return state_.names->traits(candidate.name).may_be_brdf_or_albedo;
    };
    if (!std::ranges::all_of(all, may_be_albedo)) std::erase_if(all, may_be_albedo);
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

bool is_root_candidate(const NameTraits& traits, const CheckedDefinition& checked) {
  const bool has_directions = checked.signature.parameters.size() >= 2 && !checked.signature.has_implied_parameters;
  return traits.may_be_brdf || (traits.may_be_brdf_or_albedo && has_directions);
}

}  // namespace texbrdf
