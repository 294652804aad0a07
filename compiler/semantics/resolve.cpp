#include "semantics/resolve.h"

#include "semantics/implied_angle.h"
#include "semantics/name_spelling.h"
#include "semantics/nearest_name.h"
#include "semantics/number_places.h"
#include "semantics/small_name_map.h"

namespace texbrdf {
namespace {

/// The commands that an unknown one may be a misspelling of.
const NearestName& known_commands() {
  static const NearestName all = [] {
    NearestName commands;
#define COMMAND(name, spelling, category) commands.add("\\" spelling);
#include "syntax/commands.def"
#undef COMMAND
    for (std::string_view letter : greek_letters()) commands.add("\\" + std::string(letter));
    return commands;
  }();
  return all;
}

// Steps of comparing names for the unknown commands of one definition; those beyond it get no suggestion.
constexpr uint64_t kMaxComparisonSteps = 200'000;

class Resolver {
 public:
  Resolver(const DefinitionView& view, CheckedDefinition& checked) : view_(view), checked_(checked) {
    body_.referents.resize(view.slot_count());
    body_.leaves.resize(view.slot_count());
  }

  ResolvedBody run() {
    read_left();
    for (uint32_t node = view_.body_begin(); node < view_.body_end(); ++node) {
      if (view_.node(NodeId{node}).kind == NodeKind::Name) read_name_node(NodeId{node});
    }
    return std::move(body_);
  }

 private:
  void read_left() {
    const NodeId name = view_.syntax.name;
    body_.referents[view_.slot(name)] = {Referent::Kind::Definition, view_.name(name).value};
    const NameTraits& traits = view_.table.traits(view_.name(name));
    if (traits.is_reserved) report_reserved(name);
    if (traits.convention && convention_constant(*traits.convention)) report(Code::ConstantRedefined, name);
    if (view_.node(view_.syntax.left).kind != NodeKind::Signature) return;
    for (NodeId parameter : view_.block.tree.children(view_.syntax.left).subspan(1)) read_parameter(parameter);
  }

  void read_parameter(NodeId node) {
    const NameId name = view_.name(node);
    const auto position = static_cast<uint32_t>(checked_.parameters.size());
    CheckedParameter& parameter = checked_.parameters.emplace_back();
    parameter.node = node;
    parameter.name = name;
    body_.referents[view_.slot(node)] = {Referent::Kind::Parameter, position};
    if (!name.valid()) return;
    const NameTraits& traits = view_.table.traits(name);
    parameter.inferred = !traits.is_vector;
    if (traits.is_vector) parameter.type = Type::Vector;
    if (traits.convention) parameter.shadowed.push_back(*traits.convention);
    if (traits.is_reserved) report_reserved(node);
    if (parameter_names_.insert(name)) {
      parameter_positions_.push_back(position);
    } else {
      report_repeated(node, checked_.parameters[*position_of(name)].node);
    }
  }

  std::optional<uint32_t> position_of(NameId name) const {
    const std::optional<uint32_t> index = parameter_names_.find(name);
    if (!index) return std::nullopt;
    return parameter_positions_[*index];
  }

  void read_name_node(NodeId node) {
    const NameId name = view_.name(node);
    if (!name.valid() || body_.is_skipped(view_.node(node))) return;
    if (const std::optional<uint32_t> position = position_of(name)) {
      refer(node, {Referent::Kind::Parameter, *position}, Type::Error, false);
      return;
    }
    if (const NameFact& fact = view_.facts.fact(name); fact.kind == NameFact::Kind::Defined) {
      refer(node, {Referent::Kind::Definition, name.value}, fact.signature.result, fact.signature.is_function);
      return;
    }
    const NameTraits& traits = view_.table.traits(name);
    if (const std::optional<ParameterAngle> angle = angle_of_parameter(name, traits)) {
      CheckedParameter& parameter = checked_.parameters[angle->position];
      if (parameter.inferred) parameter.type = Type::Vector;
      refer(node, angle_referent(*angle), Type::Real, false);
    } else if (traits.meaning() && !(is_usual_direction(traits) && numbers_.is_number(name))) {
      const auto index = static_cast<uint32_t>(*traits.meaning());
      refer(node, {Referent::Kind::Convention, index}, convention_entry(*traits.meaning()).type, false);
    } else {
      report_unresolved(node, traits);
    }
  }

  static bool is_usual_direction(const NameTraits& traits) {
    return traits.usual_meaning && convention_entry(*traits.usual_meaning).type == Type::Vector;
  }

  /// What is no convention by its own spelling is the angle of the parameter whose name it bears. Where papers mean
  /// something by the angle, or by nothing else than a number, the parameter has to look like a direction.
  std::optional<ParameterAngle> angle_of_parameter(NameId name, const NameTraits& traits) const {
    if (traits.convention || checked_.parameters.empty()) return std::nullopt;
    const std::optional<ImpliedAngle> angle = implied_angle(view_.table.text(name));
    if (!angle) return std::nullopt;
    for (uint32_t i = 0; i < checked_.parameters.size(); ++i) {
      const NameId parameter = checked_.parameters[i].name;
      if (!parameter.valid() || direction_label(view_.table.text(parameter)) != angle->label) continue;
      if (!traits.usual_meaning || looks_like_direction(parameter)) return ParameterAngle{angle->kind, i};
    }
    return angle->label.empty() ? angle_of_only_direction(angle->kind) : std::nullopt;
  }

  /// A bare `\theta` in `D(\vec{h})`.
  std::optional<ParameterAngle> angle_of_only_direction(Convention kind) const {
    std::optional<ParameterAngle> only;
    for (uint32_t i = 0; i < checked_.parameters.size(); ++i) {
      const NameId parameter = checked_.parameters[i].name;
      if (!parameter.valid() || !looks_like_direction(parameter)) continue;
      if (only) return std::nullopt;
      only = {kind, i};
    }
    return only;
  }

  bool looks_like_direction(NameId parameter) const {
    const NameTraits& traits = view_.table.traits(parameter);
    return traits.is_vector || is_usual_direction(traits) || view_.table.text(parameter).starts_with("\\omega");
  }

  void refer(NodeId node, Referent referent, Type type, bool is_function) {
    const uint32_t slot = view_.slot(node);
    body_.referents[slot] = referent;
    const bool is_callee = view_.is_callee(node);
    if (is_callee == is_function) {
      body_.leaves[slot] = type;
    } else if (is_callee) {
      report(Code::NotAFunction, node);
    } else {
      report(Code::FunctionAsValue, node);
    }
  }

  void report_unresolved(NodeId node, const NameTraits& traits) {
    if (traits.is_reserved) {
      report_reserved(node);
    } else if (traits.is_foreign_command) {
      report_unknown_command(node);
      skip_groups_behind(view_.node(node).end_token);
    } else {
      checked_.diagnostics.push_back(
          make_diagnostic(Code::UndefinedName, view_.at(node), {view_.name_text(node), view_.defined_text(), ""}));
    }
  }

  void skip_groups_behind(uint32_t token) {
    const auto end = static_cast<uint32_t>(view_.block.tokens.size() - 1);
    uint32_t behind = token;
    while (view_.token(behind).kind == TokenKind::OpenBrace) behind = behind_closer(view_.block, behind, end);
    if (behind > token) body_.skipped.push_back({token, behind});
  }

  void report(Code code, NodeId node) {
    checked_.diagnostics.push_back(make_diagnostic(code, view_.at(node), {view_.name_text(node)}));
  }

  void report_repeated(NodeId node, NodeId first) {
    report(Code::RepeatedParameter, node);
    checked_.diagnostics.back().related.push_back({view_.at(first), "first here"});
  }

  void report_unknown_command(NodeId node) {
    report(Code::UnknownCommand, node);
    uint32_t command = view_.node(node).first_token;
    while (view_.token(command).kind != TokenKind::Macro && command + 1 < view_.node(node).end_token) ++command;
    const auto nearest = known_commands().find(view_.block.token_text(command), comparison_steps_);
    if (!nearest) return;
    Fix fix{.title = "replace by `" + *nearest + "`", .edits = {{view_.at_token(command), *nearest}}};
    checked_.diagnostics.back().fixes.push_back(std::move(fix));
  }

  void report_reserved(NodeId node) {
    uint32_t word = view_.node(node).first_token;
    while (view_.token(word).kind != TokenKind::Word) ++word;
    const std::string text(view_.block.token_text(word));
    Diagnostic diagnostic = make_diagnostic(Code::ReservedWord, view_.at(node), {text});
    const uint32_t begin = view_.token(word).span.begin;
    const Location before{.file = {}, .block = {}, .span = {begin, begin}};
    diagnostic.fixes.push_back({.title = "write `\\" + text + "`", .edits = {{before, "\\"}}});
    checked_.diagnostics.push_back(std::move(diagnostic));
  }

  const DefinitionView& view_;
  CheckedDefinition& checked_;
  NumberPlaces numbers_{view_};
  ResolvedBody body_;
  SmallNameMap parameter_names_;
  std::vector<uint32_t> parameter_positions_;  // of each name's first parameter
  uint64_t comparison_steps_ = kMaxComparisonSteps;
};

}  // namespace

ResolvedBody resolve_names(const DefinitionView& view, CheckedDefinition& checked) {
  return Resolver(view, checked).run();
}

SmallNameMap mentioned_names(const ParsedBlock& block, const DefinitionSyntax& definition, const BlockNames& names) {
  SmallNameMap hidden;
  if (block.tree.node(definition.left).kind == NodeKind::Signature) {
    for (NodeId parameter : block.tree.children(definition.left).subspan(1)) {
      const NameId name = names.by_node[parameter.value];
      if (name.valid()) hidden.insert(name);
    }
  }
  SmallNameMap mentioned;
  for (uint32_t node = definition.left.value + 1; node <= definition.body.value; ++node) {
    const NameId name = names.by_node[node];
    if (name.valid() && !hidden.find(name)) mentioned.insert(name);
  }
  return mentioned;
}

}  // namespace texbrdf
