#include <algorithm>
#include <optional>
#include <span>
#include <unordered_set>
#include <utility>

#include "analysis/macro_places.h"
#include "analysis/snapshot_state.h"
#include "analysis/tuple_fix.h"
#include "semantics/nearest_name.h"

namespace texbrdf {
namespace {

// Reading the diagnostics stays quick in a document where everything is undefined: names beyond it get no suggestion.
constexpr size_t kMaxSuggestions = 50;
constexpr uint64_t kMaxParameterSteps = 100'000;

// Each takes a walk over its definition.
constexpr size_t kMaxTupleFixes = 50;

constexpr size_t kMaxToldOfCycle = 12;

void put_into_block(Diagnostic& diagnostic, BlockId block) {
  diagnostic.where.block = block;
  for (RelatedPlace& place : diagnostic.related) place.where.block = block;
  for (Fix& fix : diagnostic.fixes) {
    for (Edit& edit : fix.edits) edit.where.block = block;
  }
}

/// Suggests names for undefined ones.
class Suggestions {
 public:
  explicit Suggestions(const Snapshot::State& state) : state_(state) {}

  /// The definition whose undefined names come next.
  void enter(const CheckedDefinition& inside) {
    parameters_ = {};
    for (const CheckedParameter& parameter : inside.parameters) {
      if (parameter.name.valid()) parameters_.add(state_.names->text(parameter.name));
    }
  }

  void add_to(Diagnostic& undefined) {
    const std::string& wanted = undefined.arguments[0];
    if (!asked_.contains(wanted) && asked_.size() >= kMaxSuggestions) return;
    asked_.insert(wanted);
    uint64_t steps = kMaxParameterSteps;
    std::optional<std::string> nearest = parameters_.find(wanted, steps);
    if (!nearest) nearest = state_.suggestions->nearest(wanted, state_.segments, *state_.names);
    if (!nearest) return;
    undefined.arguments[2] = "; did you mean `" + *nearest + "`?";
    undefined.fixes.push_back({.title = "replace by `" + *nearest + "`", .edits = {{undefined.where, *nearest}}});
  }

 private:
  const Snapshot::State& state_;
  NearestName parameters_;
  std::unordered_set<std::string> asked_;
};

class Collector {
 public:
  explicit Collector(const Snapshot::State& state) : state_(state), suggestions_(state) {}

  std::vector<Report> run() {
    state_.segments.visit_where([](const Segment::Measure& sum) { return sum.reports > 0; },
                                [&](const Segment& segment, const Segment::Measure& before) {
                                  take_block(state_.located(segment, before));
                                  return true;
                                });
    for (const Cycle& cycle : *state_.cycles) report_cycle(cycle);
    std::ranges::sort(all_, {}, [](const Report& r) { return place_and_content(r.diagnostic); });
    return std::move(all_);
  }

 private:
  std::string name_text(NameId name) const { return shown_name(state_.names->text(name)); }
  Location name_place(NameId name) const { return state_.locate(*state_.find(name)).name_place(); }

  void take_block(const LocatedBlock& block) {
    const size_t first = all_.size();
    take_what_was_read(block);
    for (uint32_t i = 0; i < block.block->definitions.size(); ++i) take_definition({block, i});
    if (const MacroExpansion* expansion = block.block->expansion) {
      for (size_t i = first; i < all_.size(); ++i) follow_macros(all_[i].diagnostic, *expansion);
    }
    for (const Directive& directive : block.block->analysed->directives) {
      if (directive.kind == Directive::Kind::Allow) silence(directive.argument, first);
    }
  }

  /// What concerns no definition stays as it is, whatever the root needs.
  void take_what_was_read(const LocatedBlock& block) {
    const std::span<const Diagnostic> all(block.parsed().diagnostics);
    const auto& definitions = block.parsed().definitions;
    uint32_t next = 0;
    for (uint32_t i = 0; i < definitions.size(); ++i) {
      const uint32_t first = definitions[i].first_diagnostic;
      const uint32_t end = definitions[i].end_diagnostic;
      take(all.subspan(next, first - next), block, NameId{});
      take(all.subspan(first, end - first), block, block.block->analysed->defined(i));
      next = end;
    }
    take(all.subspan(next), block, NameId{});
  }

  /// What is wrong in what a macro made is mended where the macro is defined.
  void follow_macros(Diagnostic& diagnostic, const MacroExpansion& expansion) {
    std::erase_if(diagnostic.fixes, [&](const Fix& fix) {
      return !std::ranges::all_of(fix.edits,
                                  [&](const Edit& edit) { return expansion.is_replaceable(edit.where.span); });
    });
    const MacroUse* const use = expansion.maker_of(diagnostic.where.span);
    if (use == nullptr || diagnostic.severity == Severity::Hint) return;
    if (!macros_) macros_.emplace(state_);
    if (const auto place = macros_->definition_of(use->name)) {
      diagnostic.related.push_back({*place, "`\\" + use->name + "` is defined here"});
    }
  }

  void silence(const std::string& code, size_t first) {
    const auto begin = all_.begin() + static_cast<std::ptrdiff_t>(first);
    all_.erase(std::remove_if(begin, all_.end(),
                              [&](const Report& report) { return code_name(report.diagnostic.code) == code; }),
               all_.end());
  }

  void take(std::span<const Diagnostic> diagnostics, const LocatedBlock& block, NameId about) {
    for (const Diagnostic& diagnostic : diagnostics) {
      all_.push_back({diagnostic, about});
      put_into_block(all_.back().diagnostic, block.id);
    }
  }

  void take_definition(const LocatedDefinition& definition) {
    const CheckedDefinition& checked = definition.checked();
    const size_t first = all_.size();
    take(checked.diagnostics, definition.at, definition.name());
    if (all_.size() > first) suggestions_.enter(checked);
    const bool is_remark = !definition.placed().in_force && is_in_prose(definition);
    for (size_t i = first; i < all_.size(); ++i) {
      if (is_remark && is_demotable(all_[i].diagnostic)) all_[i].diagnostic.severity = Severity::Hint;
      if (all_[i].diagnostic.code == Code::UndefinedName) suggestions_.add_to(all_[i].diagnostic);
      add_tuple_fix(definition, all_[i].diagnostic);
    }
    report_definition(definition);
  }

  void add_tuple_fix(const LocatedDefinition& definition, Diagnostic& problem) {
    if (!may_want_tuple(problem.code) || tuple_fixes_ >= kMaxTupleFixes) return;
    ++tuple_fixes_;
    if (std::optional<Fix> fix = tuple_fix(state_, definition, problem)) problem.fixes.push_back(*std::move(fix));
  }

  void report_definition(const LocatedDefinition& definition) {
    const NameId name = definition.name();
    if (!definition.placed().in_force) {
      report_redefinition(definition);
    } else if (const std::optional<Convention> convention = state_.names->traits(name).convention) {
      const std::string meaning(convention_entry(*convention).meaning);
      add(make_diagnostic(Code::ConventionRedefined, definition.name_place(), {name_text(name), meaning}), name);
    }
  }

  void add(Diagnostic diagnostic, NameId about) { all_.push_back({std::move(diagnostic), about}); }

  void report_redefinition(const LocatedDefinition& definition) {
    const NameId name = definition.name();
    const std::optional<DefinitionKey> first = state_.find(name);
    if (!first) return;
    add(make_diagnostic(Code::Redefinition, definition.name_place(), {name_text(name)}), name);
    if (is_in_prose(definition)) all_.back().diagnostic.severity = Severity::Hint;
    all_.back().diagnostic.related.push_back({state_.locate(*first).name_place(), "this one is in force"});
  }

  /// Prose says values again, and says others for what it discusses.
  static bool is_in_prose(const LocatedDefinition& definition) {
    return definition.at.block->analysed->standing(definition.index_in_block) != Standing::Display;
  }

  void report_cycle(const Cycle& cycle) {
    const std::span<const NameId> told = std::span(cycle).first(std::min(cycle.size(), kMaxToldOfCycle));
    std::string path;
    for (NameId name : told) path += "`" + name_text(name) + "` → ";
    if (told.size() < cycle.size()) path += "… → ";
    const Location where = cycle.size() == 1 ? own_use(cycle.front()) : name_place(cycle.front());
    Diagnostic diagnostic =
        make_diagnostic(Code::CircularDefinition, where, {path + "`" + name_text(cycle.front()) + "`"});
    for (NameId name : told.subspan(1)) {
      diagnostic.related.push_back({name_place(name), "`" + name_text(name) + "` is on the way"});
    }
    add(std::move(diagnostic), cycle.front());
  }

  /// Where a definition of itself mentions itself.
  Location own_use(NameId name) const {
    const LocatedDefinition definition = state_.locate(*state_.find(name));
    for (const NamePlace& place : definition.at.block->analysed->places_of(definition.index_in_block)) {
      const bool is_use = place.name == name && place.node != definition.syntax().name;
      if (is_use) return {.file = {}, .block = definition.at.id, .span = place.span};
    }
    return definition.name_place();
  }

  const Snapshot::State& state_;
  Suggestions suggestions_;
  size_t tuple_fixes_ = 0;
  std::optional<MacroPlaces> macros_;  // found when they are first asked for
  std::vector<Report> all_;
};

}  // namespace

std::vector<Report> document_reports(const Snapshot::State& state) {
  return Collector(state).run();
}

}  // namespace texbrdf
