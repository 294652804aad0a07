#include <algorithm>
#include <utility>

#include "analysis/needed_names.h"
#include "analysis/root_arguments.h"
#include "analysis/snapshot_state.h"

namespace texbrdf {
namespace {

/// A document that is a collection of equations would drown in hints: only the first are told.
constexpr uint32_t kMaxUnused = 100;

/// What a root needs that is another than the document's.
std::vector<bool> needed_by(const Snapshot::State& state, NameId root) {
  const std::optional<DefinitionKey> own = state.find(root);
  const CheckedDefinition* const checked = own ? &state.locate(*own).checked() : nullptr;
  return needed_names(state.names->size(), root, checked, [&](NameId name) -> std::span<const NameId> {
    const std::optional<DefinitionKey> key = state.find(name);
    if (!key) return {};
    return state.locate(key->block).block->analysed->mentions_of(key->index_in_block);
  });
}

class RootDiagnostics {
 public:
  RootDiagnostics(const Snapshot::State& state, std::string_view root)
      : state_(state), root_(root), root_name_(state.names->find(root)) {
    if (root_name_.valid()) key_ = state.find(root_name_);
  }

  std::vector<Diagnostic> run() {
    for (const Report& report : state_.reports) all_.push_back(report.diagnostic);
    if (key_) {
      demote_what_is_not_needed();
      check_shape();
      hint_unused();
    } else {
      report_missing();
    }
    report_includes();
    follow_directives();
    std::ranges::sort(all_, {}, [](const Diagnostic& d) { return place_and_content(d); });
    return std::move(all_);
  }

 private:
  // A paper also contains equations that are not code.
  void demote_what_is_not_needed() {
    if (std::ranges::none_of(state_.reports, &Report::is_demotable)) return;
    const bool is_own_root = root_ == state_.root.name_or_f();
    if (is_own_root && state_.needed) {
      demote_all_but(*state_.needed);
    } else {
      demote_all_but(needed_by(state_, root_name_));
    }
  }

  void demote_all_but(const std::vector<bool>& needed) {
    for (size_t i = 0; i < all_.size(); ++i) {
      const Report& report = state_.reports[i];
      if (report.is_demotable() && !needed[report.about.value]) all_[i].severity = Severity::Hint;
    }
  }

  void check_shape() {
    const LocatedDefinition definition = state_.locate(*key_);
    const Signature& signature = definition.checked().signature;
    if (!definition.checked().sound || is_brdf(signature)) return;
    if (root_arguments(state_, definition)) return;
    if (signature.has_implied_parameters && report_implied(definition)) return;
    all_.push_back(make_diagnostic(Code::RootShape, definition.name_place(), {root_, signature_text(signature)}));
  }

  // Nobody says what the names mean that the root leaves to those that mention it. False where all are known.
  bool report_implied(const LocatedDefinition& root) {
    const size_t before = all_.size();
    for (const CheckedParameter& parameter : root.checked().parameters) {
      if (state_.names->traits(parameter.name).meaning() || state_.find(parameter.name)) continue;
      report_undefined(root, parameter);
    }
    return all_.size() > before;
  }

  // Where the name itself stands, which may be in what the root is made of.
  void report_undefined(LocatedDefinition user, const CheckedParameter& missing) {
    const NameId name = missing.name;
    NodeId node = missing.node;
    while (const std::optional<LocatedDefinition> used = definition_at(user, node)) {
      if (used->name() == name) break;
      const std::vector<CheckedParameter>& parameters = used->checked().parameters;
      const auto found = std::ranges::find(parameters, name, &CheckedParameter::name);
      if (found == parameters.end()) break;
      user = *used;
      node = found->node;
    }
    const Location where{.file = {}, .block = user.at.id, .span = user.at.parsed().span(node)};
    const std::string shown = shown_name(state_.names->text(name));
    const std::string definition = shown_name(state_.names->text(user.name()));
    all_.push_back(make_diagnostic(Code::UndefinedName, where, {shown, definition, ""}));
  }

  /// The definition that a Name node mentions.
  std::optional<LocatedDefinition> definition_at(const LocatedDefinition& user, NodeId node) const {
    const Referent& referent = user.checked().referents[node.value - user.syntax().first_node];
    if (referent.kind != Referent::Kind::Definition) return std::nullopt;
    const std::optional<DefinitionKey> key = state_.find(NameId{referent.index});
    return key ? std::optional(state_.locate(*key)) : std::nullopt;
  }

  // A document without blocks is none of ours, and a block whose left side could not be read may have been the root.
  void report_missing() {
    const Segment::Measure sum = state_.segments.measure();
    if (sum.definitions == 0 || sum.without_definition > 0) return;
    const DefinitionId last = state_.view.definition(sum.definitions - 1);
    all_.push_back(make_diagnostic(Code::MissingRoot, state_.locate(last).name_place(), {root_}));
  }

  void hint_unused() {
    const std::vector<NameId> arguments = argument_names(state_.locate(*key_).checked());
    uint32_t told = 0;
    state_.segments.visit_where([](const Segment::Measure& sum) { return sum.unused > 0; },
                                [&](const Segment& segment, const Segment::Measure& before) {
                                  const LocatedBlock block = state_.located(segment, before);
                                  for (uint32_t i = 0; i < block.block->definitions.size(); ++i)
                                    hint_unused({block, i}, arguments);
                                  told += block.block->unused;
                                  return told < kMaxUnused;
                                });
  }

  void hint_unused(const LocatedDefinition& definition, const std::vector<NameId>& arguments) {
    const PlacedDefinition& placed = definition.placed();
    if (!placed.in_force || placed.is_used || definition.name() == root_name_) return;
    if (std::ranges::find(arguments, definition.name()) != arguments.end()) return;
    const std::string name = shown_name(state_.names->text(definition.name()));
    all_.push_back(make_diagnostic(Code::UnusedDefinition, definition.name_place(), {name}));
  }

  void follow_directives() {
    state_.segments.visit_where([](const Segment::Measure& sum) { return sum.directives > 0; },
                                [&](const Segment& segment, const Segment::Measure& before) {
                                  follow(segment, before.bytes);
                                  return true;
                                });
  }

  void follow(const Segment& segment, uint32_t offset) {
    for (const Directive& directive : directives_of(segment)) {
      if (directive.kind == Directive::Kind::Allow && !segment.block) {
        std::erase_if(all_, [&](const Diagnostic& d) { return code_name(d.code) == directive.argument; });
      } else if (directive.kind == Directive::Kind::Unknown) {
        const Span in_project{offset + directive.span.begin, offset + directive.span.end};
        const Location where = place_in_prose(in_project);
        all_.push_back(make_diagnostic(Code::UnknownDirective, where, {state_.text.slice(in_project)}));
      }
    }
  }

  Location place_in_prose(Span in_project) const {
    const uint32_t begin = state_.view.offset(in_project.begin);
    return {.file = {}, .block = kProse, .span = {begin, begin + in_project.size()}};
  }

  void report_includes() {
    if (state_.include_problems->empty()) return;
    state_.segments.visit_where([](const Segment::Measure& sum) { return sum.includes > 0; },
                                [&](const Segment& segment, const Segment::Measure& before) {
                                  for (const Include& include : segment.remarks->includes)
                                    report_include(include, before.bytes);
                                  return true;
                                });
  }

  void report_include(const Include& include, uint32_t offset) {
    const FileId file = state_.text.file_at(offset);
    for (const IncludeProblem& problem : *state_.include_problems) {
      if (problem.file != file || problem.target != include.target) continue;
      const Location where = place_in_prose({offset + include.span.begin, offset + include.span.end});
      all_.push_back(make_diagnostic(problem.code, where, {problem.argument}));
    }
  }

  const Snapshot::State& state_;
  const std::string root_;
  const NameId root_name_;
  std::optional<DefinitionKey> key_;
  std::vector<Diagnostic> all_;
};

}  // namespace

bool is_brdf(const Signature& signature) {
  return (signature.result == Type::Real || is_triple(signature.result)) && has_brdf_parameters(signature);
}

std::vector<Diagnostic> diagnostics_for_root(const Snapshot::State& state, std::string_view root) {
  return RootDiagnostics(state, root).run();
}

}  // namespace texbrdf
