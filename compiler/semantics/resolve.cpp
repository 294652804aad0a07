#include "semantics/resolve.h"

#include <algorithm>

#include "semantics/argument_expressions.h"
#include "semantics/component.h"
#include "semantics/direction_places.h"
#include "semantics/implied_angle.h"
#include "semantics/implied_mentions.h"
#include "semantics/implied_parameters.h"
#include "semantics/known_names.h"
#include "semantics/name_spelling.h"
#include "semantics/nearest_name.h"
#include "semantics/number_places.h"
#include "semantics/resolve_bound.h"
#include "semantics/small_name_map.h"
#include "semantics/unread_arguments.h"
#include "syntax/matrix_power.h"

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
    skip_damaged_binders();
    ArgumentExpressions expressions(view_, checked_.parameters);
    if (expressions.has_any()) expressions.find(body_);
    for (uint32_t node = view_.body_begin(); node < view_.body_end(); ++node) {
      if (view_.node(NodeId{node}).kind != NodeKind::Name) continue;
      may_be_undefined_ = expressions.is_operand(NodeId{node});
      read_name_node(NodeId{node});
      if (!may_be_undefined_) expressions.note_use(NodeId{node}, body_);
    }
    if (!body_.bound.empty()) scopes_.decide_terms();
    checked_.signature.is_callable = expressions.are_all_that_is_used();
    read_expressions_of_left_side();
    return std::move(body_);
  }

 private:
  /// What a sum without bounds is taken of has a name that nothing defines.
  void skip_damaged_binders() {
    if (view_.syntax.readable) return;
    uint32_t first_skipped = UINT32_MAX;  // outer nodes come first, then what stands in front of them
    for (uint32_t node = view_.body_end(); node-- > view_.body_begin();) {
      const Node& n = view_.node(NodeId{node});
      if (n.kind != NodeKind::Error || n.child_count == 0) continue;
      const TokenKind kind = view_.token(n.token).kind;
      const bool is_binder = kind == TokenKind::BigOperator || kind == TokenKind::Integral ||
                             kind == TokenKind::OpenIntegral || kind == TokenKind::DerivativeFrac;
      if (!is_binder || n.first_token >= first_skipped) continue;
      body_.skipped.push_back({n.first_token, n.end_token});
      first_skipped = n.first_token;
    }
    std::ranges::reverse(body_.skipped);
  }

  void read_left() {
    const NodeId name = view_.syntax.name;
    body_.referents[view_.slot(name)] = {Referent::Kind::Definition, view_.name(name).value};
    const NameTraits& traits = view_.table.traits(view_.name(name));
    if (traits.is_reserved) report_reserved(name);
    if (traits.convention && convention_constant(*traits.convention)) report(Code::ConstantRedefined, name);
    if (view_.node(view_.syntax.left).kind != NodeKind::Signature) return;
    for (NodeId parameter : view_.block.tree.children(view_.syntax.left).subspan(1)) read_parameter(parameter);
  }

  void read_parameter(NodeId given) {
    const NodeId name_node = view_.block.parameter_name(given);
    const NodeId node = name_node.valid() ? name_node : given;
    const NameId name = view_.name(node);
    const auto position = static_cast<uint32_t>(checked_.parameters.size());
    CheckedParameter& parameter = checked_.parameters.emplace_back();
    parameter.node = node;
    parameter.given = given;
    parameter.name = name;
    body_.referents[view_.slot(node)] = {Referent::Kind::Parameter, position};
    parameter.inferred = node != name_node;
    if (!name.valid()) return;
    const NameTraits& traits = view_.table.traits(name);
    const bool is_angle = given != node;
    if (is_angle) parameter.function = view_.token(view_.node(given).token).command;
    parameter.inferred = !traits.is_vector && !is_angle;
    if (traits.is_vector) parameter.type = Type::Vector;
    if (is_angle) parameter.type = Type::Real;
    if (traits.convention) parameter.shadowed.push_back(*traits.convention);
    if (traits.is_reserved) report_reserved(node);
    if (parameter_names_.insert(name)) {
      parameter_positions_.push_back(position);
    } else {
      report_repeated(node, checked_.parameters[*position_of(name)].node);
    }
  }

  /// Of a plain definition (implied_parameters.h). It is mentioned at the node, by itself or by what it is made of.
  TypedReferent imply_parameter(NodeId node, NameId name) {
    const auto position = static_cast<uint32_t>(checked_.parameters.size());
    CheckedParameter& parameter = checked_.parameters.emplace_back();
    parameter.node = parameter.given = node;
    parameter.name = name;
    parameter.inferred = !view_.table.traits(name).is_vector;
    if (!parameter.inferred) parameter.type = Type::Vector;
    checked_.signature.has_implied_parameters = true;
    parameter_names_.insert(name);
    parameter_positions_.push_back(position);
    return {{Referent::Kind::Parameter, position}, Type::Error};
  }

  bool is_plain() const { return view_.syntax.left == view_.syntax.name; }

  /// A name that nothing defines but functions call a parameter so; a bare `\theta` is the angle of one.
  bool may_be_implied(NameId name) const {
    if (!is_plain()) return false;
    const std::optional<ImpliedAngle> angle = implied_angle(view_.table.text(name));
    return view_.facts.fact(name).is_parameter || (angle && angle->label.empty());
  }

  /// Whether a name of the convention means what functions of the display make of their parameters.
  bool is_implied_here(NameId name) {
    if (!is_plain() || may_be_undefined_) return false;
    if (!of_users_) of_users_ = parameters_of_users(view_);
    if (of_users_->empty()) return false;
    if (std::ranges::find(*of_users_, name) != of_users_->end()) return true;
    const NameTraits& traits = view_.table.traits(name);
    if (!traits.convention) return angle_among(*of_users_, name, traits).has_value();
    return std::ranges::any_of(*of_users_, [&](NameId parameter) {
      const std::optional<Convention> hidden =
          parameter.valid() ? view_.table.traits(parameter).convention : std::nullopt;
      return hidden && depends_on(*traits.convention, std::span(&*hidden, 1));
    });
  }

  /// What the names in `\phi_r - \phi_i` on a left side mean is nothing that could be wrong.
  void read_expressions_of_left_side() {
    may_be_undefined_ = true;
    for (const CheckedParameter& parameter : checked_.parameters) {
      if (parameter.name.valid()) continue;
      const uint32_t first = view_.node(parameter.given).first_token;
      for (uint32_t node = parameter.given.value; node-- > view_.syntax.name.value;) {
        if (view_.node(NodeId{node}).first_token < first) break;
        if (view_.node(NodeId{node}).kind == NodeKind::Name) read_name_node(NodeId{node});
      }
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
    if (const auto bound = scopes_.bound(node)) return refer_to_bound(node, *bound);
    scopes_.advance_to(node);
    const NameTraits& traits = view_.table.traits(name);
    if (directions_.is_direction(node)) {
      refer(node, conventional_meaning(traits));
    } else if (const std::optional<TypedReferent> stated = stated_meaning(name)) {
      refer(node, *stated);
    } else if (const auto indexed = scopes_.indexed(node)) {
      const Signature& signature = body_.indexed[indexed->index].signature;
      refer(node, {*indexed, signature.result, signature.is_function});
    } else if (const auto derivative = scopes_.derivative(node)) {
      refer(node, {*derivative, view_.facts.fact(NameId{derivative->index}).signature.result, true});
    } else if (const auto direction = scopes_.direction(name)) {
      refer_to_bound(node, *direction);
    } else if (is_implied_here(name)) {
      refer(node, imply_parameter(node, name));
    } else if (const std::optional<TypedReferent> unstated = unstated_meaning(name)) {
      refer(node, *unstated);
    } else if (traits.builtin) {
      refer(node, {{Referent::Kind::Builtin, static_cast<uint32_t>(*traits.builtin)}, Type::Error, true});
    } else if (!may_be_undefined_) {
      read_unknown(node, traits);
    }
  }

  std::optional<TypedReferent> meaning_of(NameId name) {
    std::optional<TypedReferent> stated = stated_meaning(name);
    return stated ? stated : unstated_meaning(name);
  }

  /// What a name means that is neither a parameter nor defined.
  std::optional<TypedReferent> unstated_meaning(NameId name) {
    const NameTraits& traits = view_.table.traits(name);
    if (const std::optional<ParameterAngle> angle = angle_of_parameter(name, traits)) {
      take_as_vector(angle->position);
      return TypedReferent{angle_referent(*angle), Type::Real};
    }
    if (!traits.convention) {
      if (std::optional<DerivedNumber> derived = derived_number(name)) return refer_to(*derived);
    }
    const bool means_something = traits.meaning() && !(is_usual_direction(traits) && numbers_.is_number(name));
    return means_something ? std::optional(conventional_meaning(traits)) : std::nullopt;
  }

  /// Of a parameter, or a name that the document defines.
  std::optional<TypedReferent> stated_meaning(NameId name) const {
    if (const std::optional<uint32_t> position = position_of(name)) {
      return TypedReferent{{Referent::Kind::Parameter, *position}, Type::Error};
    }
    const NameFact& fact = view_.facts.fact(name);
    if (fact.kind != NameFact::Kind::Defined) return std::nullopt;
    return TypedReferent{{Referent::Kind::Definition, name.value}, fact.signature.result, fact.signature.is_function};
  }

  static TypedReferent conventional_meaning(const NameTraits& traits) {
    const Convention meaning = *traits.meaning();
    return {{Referent::Kind::Convention, static_cast<uint32_t>(meaning)}, convention_entry(meaning).type};
  }

  TypedReferent refer_to(const DerivedNumber& derived) {
    checked_.derived.push_back(derived);
    const bool is_positive_part = derived.kind == DerivedNumber::Kind::PositivePart;
    return {{Referent::Kind::Derived, static_cast<uint32_t>(checked_.derived.size() - 1)},
            is_positive_part ? derived.vector.type : Type::Real};
  }

  std::optional<DerivedNumber> derived_number(NameId name) {
    const std::string_view text = view_.table.text(name);
    if (const std::optional<DerivedNumber> entry = entry_of(text)) return entry;
    if (const std::optional<DerivedNumber> positive = positive_part_of(name_of_positive_part(text))) return positive;
    const std::optional<ComponentName> component = component_name(text);
    if (component && component->axis < 3) {
      if (const std::optional<TypedReferent> vector = vector_of(*component)) {
        return DerivedNumber{DerivedNumber::Kind::Component, component->axis, *vector};
      }
    }
    const std::optional<ImpliedAngle> angle = implied_angle(text);
    if (!angle || angle->label.empty()) return std::nullopt;
    for (const std::string& direction : directions_called(angle->label)) {
      const std::optional<TypedReferent> vector = stated_vector(direction);
      if (!vector || vector->referent.kind != Referent::Kind::Definition) continue;
      const bool is_polar = angle->kind == Convention::ThetaI;
      return DerivedNumber{is_polar ? DerivedNumber::Kind::PolarAngle : DerivedNumber::Kind::Azimuth, 0, *vector};
    }
    return std::nullopt;
  }

  /// A parameter whose type is open is a number.
  std::optional<DerivedNumber> positive_part_of(std::string_view whole) {
    const NameId name = whole.empty() ? NameId{} : view_.table.find(whole);
    std::optional<TypedReferent> found = name.valid() ? stated_meaning(name) : std::nullopt;
    if (!found || found->is_function) return std::nullopt;
    if (found->referent.kind == Referent::Kind::Parameter) {
      Type& type = checked_.parameters[found->referent.index].type;
      if (type == Type::Error) type = Type::Real;
      found->type = type;
    }
    if (found->type == Type::Tuple) found->type = Type::Colour;
    const bool has_sign = found->type == Type::Real || found->type == Type::Colour;
    return has_sign ? std::optional(DerivedNumber{DerivedNumber::Kind::PositivePart, 0, *found}) : std::nullopt;
  }

  /// `m_y` or `M_{12}` of what has entries.
  static std::optional<uint32_t> entry_index(Shape shape, const EntryName& entry) {
    const bool is_vector = shape.is_vector() && !entry.column;
    if (is_vector) return entry.row < shape.entries() ? std::optional(entry.row) : std::nullopt;
    const bool is_inside = entry.column && entry.row < shape.rows && *entry.column < shape.columns;
    return is_inside ? std::optional(entry.row * shape.columns + *entry.column) : std::nullopt;
  }

  std::optional<DerivedNumber> entry_of(std::string_view name) const {
    const std::optional<EntryName> entry = entry_name(name);
    if (!entry) return std::nullopt;
    for (const std::string& aggregate : entry->aggregates) {
      const NameId id = view_.table.find(aggregate);
      const std::optional<TypedReferent> found = id.valid() ? stated_meaning(id) : std::nullopt;
      if (!found || found->is_function || !is_aggregate(found->type)) continue;
      const std::optional<uint32_t> index = entry_index(type_shape(found->type), *entry);
      if (index) return DerivedNumber{DerivedNumber::Kind::Entry, *index, *found};
    }
    return std::nullopt;
  }

  /// A parameter that may be a vector becomes one. What is stated comes before what is usual.
  std::optional<TypedReferent> vector_of(const ComponentName& component) {
    for (const std::string& name : component.vectors) {
      std::optional<TypedReferent> vector = stated_vector(name);
      if (!vector) continue;
      if (vector->referent.kind == Referent::Kind::Parameter) vector->type = take_as_vector(vector->referent.index);
      return vector;
    }
    for (const std::string& name : component.vectors) {
      const NameTraits traits = traits_of(name);
      if (traits.meaning() && convention_entry(*traits.meaning()).type == Type::Vector) {
        return conventional_meaning(traits);
      }
    }
    return std::nullopt;
  }

  /// Names that nobody has written are not in the table.
  NameTraits traits_of(std::string_view canonical) const {
    const NameId name = view_.table.find(canonical);
    return name.valid() ? view_.table.traits(name) : name_traits(canonical);
  }

  /// Unless the parameter is something else by its spelling. Gives its type.
  Type take_as_vector(uint32_t position) {
    CheckedParameter& parameter = checked_.parameters[position];
    if (parameter.inferred) parameter.type = Type::Vector;
    return parameter.type;
  }

  /// A parameter whose type is open may be one.
  std::optional<TypedReferent> stated_vector(std::string_view canonical) const {
    const NameId name = view_.table.find(canonical);
    if (!name.valid()) return std::nullopt;
    std::optional<TypedReferent> found = stated_meaning(name);
    if (!found || found->is_function) return std::nullopt;
    const bool is_parameter = found->referent.kind == Referent::Kind::Parameter;
    if (is_parameter) found->type = checked_.parameters[found->referent.index].type;
    const bool is_open = is_parameter && checked_.parameters[found->referent.index].inferred;
    return is_open || fits(found->type, Type::Vector) ? found : std::nullopt;
  }

  static bool is_usual_direction(const NameTraits& traits) {
    return traits.usual_meaning && convention_entry(*traits.usual_meaning).type == Type::Vector;
  }

  /// What is no convention by its own spelling is the angle of the parameter whose name it bears. Where papers mean
  /// something by the angle, or by nothing else than a number, the parameter has to look like a direction.
  std::optional<ParameterAngle> angle_of_parameter(NameId name, const NameTraits& traits) const {
    if (traits.convention || checked_.parameters.empty()) return std::nullopt;
    std::vector<NameId> names;
    for (const CheckedParameter& parameter : checked_.parameters) names.push_back(parameter.name);
    return angle_among(names, name, traits);
  }

  std::optional<ParameterAngle> angle_among(std::span<const NameId> parameters, NameId name,
                                            const NameTraits& traits) const {
    const std::optional<ImpliedAngle> angle = implied_angle(view_.table.text(name));
    if (!angle) return std::nullopt;
    for (uint32_t i = 0; i < parameters.size(); ++i) {
      const NameId parameter = parameters[i];
      if (!parameter.valid() || direction_label(view_.table.text(parameter)) != angle->label) continue;
      if (!traits.usual_meaning || looks_like_direction(parameter)) return ParameterAngle{angle->kind, i};
    }
    return angle->label.empty() ? angle_of_only_direction(parameters, angle->kind) : std::nullopt;
  }

  /// A bare `\theta` in `D(\vec{h})`.
  std::optional<ParameterAngle> angle_of_only_direction(std::span<const NameId> parameters, Convention kind) const {
    std::optional<ParameterAngle> only;
    for (uint32_t i = 0; i < parameters.size(); ++i) {
      const NameId parameter = parameters[i];
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

  void refer_to_bound(NodeId node, Referent referent) {
    const bool is_angle = referent.kind == Referent::Kind::BoundAngle;
    refer(node, {referent, is_angle ? Type::Real : body_.bound[referent.index].type});
  }

  void refer(NodeId node, const TypedReferent& meaning) {
    const uint32_t slot = view_.slot(node);
    body_.referents[slot] = meaning.referent;
    const bool is_callee = view_.is_callee(node);
    if (is_callee == meaning.is_function) {
      body_.leaves[slot] = meaning.type;
      if (is_callee && !is_callable(meaning.referent)) report(Code::NotCallable, node);
    } else if (may_be_undefined_) {
      return;
    } else if (is_callee) {
      report(Code::NotAFunction, node);
    } else if (const std::optional<Type> result = imply_call(node)) {
      body_.leaves[slot] = *result;
    } else if (const std::optional<NameId> missing = missing_implied(node)) {
      report_undefined(node, *missing, view_.name_text(node));
    } else {
      report(Code::FunctionAsValue, node);
    }
  }

  bool is_callable(const Referent& callee) const {
    return callee.kind != Referent::Kind::Definition || view_.facts.fact(NameId{callee.index}).signature.is_callable;
  }

  /// `DFG`: each function takes what its parameters are called, where that is a value of the right type.
  std::optional<Type> imply_call(NodeId node) {
    const NameFact& fact = view_.facts.fact(view_.name(node));
    if (fact.kind != NameFact::Kind::Defined || !fact.signature.is_callable) return std::nullopt;
    ImpliedCall call{.node = node, .arguments = {}, .result = fact.signature.result};
    for (size_t i = 0; i < fact.parameters.size(); ++i) {
      const Type expected = fact.signature.parameters[i];
      const bool may_hand_on = fact.signature.has_implied_parameters && is_plain();
      std::optional<TypedReferent> argument;
      if (may_hand_on && is_implied_here(fact.parameters[i])) argument = hand_on(node, fact.parameters[i], expected);
      if (!argument) argument = implied_argument(fact.parameters[i], expected);
      if (!argument && may_hand_on) argument = hand_on(node, fact.parameters[i], expected);
      if (!argument) return std::nullopt;
      const bool is_colour = is_triple(argument->type) && is_componentwise(argument->type);
      const bool is_spread = fact.signature.is_spread(i) && is_colour;
      if (is_spread) call.spread |= uint64_t{1} << i;
      const bool is_known = argument->type != Type::Error;
      if (!is_spread && is_known && !fits(argument->type, fact.signature.parameters[i])) return std::nullopt;
      call.arguments.push_back(*argument);
    }
    checked_.implied_calls.push_back(call);
    return call.spread == 0 ? call.result : Type::Colour;
  }

  /// What the definition at the node leaves to those that mention it, and this one to others.
  std::optional<TypedReferent> hand_on(NodeId node, NameId name, Type expected) {
    if (stated_meaning(name)) return std::nullopt;
    TypedReferent argument = imply_parameter(node, name);
    argument.type = expected == Type::Vector ? take_as_vector(argument.referent.index)
                                             : checked_.parameters[argument.referent.index].type;
    return argument;
  }

  /// What the definition at the node is made of and has no meaning here.
  std::optional<NameId> missing_implied(NodeId node) {
    const NameFact& fact = view_.facts.fact(view_.name(node));
    if (!fact.signature.has_implied_parameters) return std::nullopt;
    const auto missing = std::ranges::find_if(fact.parameters, [this](NameId name) { return !meaning_of(name); });
    return missing == fact.parameters.end() ? std::nullopt : std::optional(*missing);
  }

  std::optional<TypedReferent> implied_argument(NameId name, Type expected) {
    if (!name.valid() || scopes_.binds(name)) return std::nullopt;
    std::optional<TypedReferent> argument = meaning_of(name);
    if (!argument || argument->is_function) return std::nullopt;
    if (argument->referent.kind == Referent::Kind::Parameter) {
      const uint32_t position = argument->referent.index;
      argument->type = expected == Type::Vector ? take_as_vector(position) : checked_.parameters[position].type;
    }
    return argument;
  }

  void read_unknown(NodeId node, const NameTraits& traits) {
    if (is_transposition_sign(view_.block, node)) {
      body_.referents[view_.slot(node)] = {Referent::Kind::Transposition, 0};
      return;
    }
    if (const std::optional<Type> unread = unread_.type_of(node)) {
      body_.leaves[view_.slot(node)] = *unread;
      return;
    }
    if (traits.is_reserved) {
      report_reserved(node);
    } else if (may_be_implied(view_.name(node))) {
      refer(node, imply_parameter(node, view_.name(node)));
    } else if (traits.is_foreign_command) {
      report_unknown_command(node);
      skip_groups_behind(view_.node(node).end_token);
    } else {
      report_undefined(node, view_.name(node), view_.defined_text());
    }
  }

  void report_undefined(NodeId node, NameId name, std::string definition) {
    std::string shown = view_.name(node) == name ? view_.name_text(node) : shown_name(view_.table.text(name));
    checked_.diagnostics.push_back(
        make_diagnostic(Code::UndefinedName, view_.at(node), {std::move(shown), std::move(definition), ""}));
  }

  void skip_groups_behind(uint32_t token) {
    const auto end = static_cast<uint32_t>(view_.block.tokens.size() - 1);
    uint32_t behind = token;
    while (view_.token(behind).kind == TokenKind::OpenBrace) behind = behind_closer(view_.block, behind, end);
    if (behind == token) return;
    const auto place = std::ranges::upper_bound(body_.skipped, token, {}, &SkippedTokens::begin);
    body_.skipped.insert(place, {token, behind});
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
  DirectionPlaces directions_{view_};
  UnreadArguments unread_{view_};
  bool may_be_undefined_ = false;  ///< the name stands where its meaning does not matter
  ResolvedBody body_;
  BoundScopes scopes_{view_, body_, checked_.diagnostics};
  std::optional<std::vector<NameId>> of_users_;  // see parameters_of_users
  SmallNameMap parameter_names_;
  std::vector<uint32_t> parameter_positions_;  // of each name's first parameter
  uint64_t comparison_steps_ = kMaxComparisonSteps;
};

}  // namespace

ResolvedBody resolve_names(const DefinitionView& view, CheckedDefinition& checked) {
  return Resolver(view, checked).run();
}

SmallNameMap mentioned_names(const ParsedBlock& block, const DefinitionSyntax& definition, const BlockNames& names) {
  const SmallNameMap hidden = hidden_names(block, definition, names);
  // Names on the left side that are not hidden stand in the expression of a parameter.
  SmallNameMap mentioned;
  for (uint32_t node = definition.name.value + 1; node <= definition.body.value; ++node) {
    const NameId name = names.by_node[node];
    if (!name.valid() || names.bound_use(NodeId{node}) != nullptr) continue;
    if (!hidden.find(name)) mentioned.insert(name);
    const StandIn* stand_in = names.stand_in(NodeId{node});
    if (stand_in == nullptr) continue;
    for (const NameId possible : stand_in->names) {
      const bool is_own = stand_in->binders.empty() && possible == names.by_node[definition.name.value];
      if (!is_own) mentioned.insert(possible);
    }
  }
  auto possible = std::ranges::upper_bound(names.possible, definition.name, {}, &PossibleName::node);
  for (; possible != names.possible.end() && possible->node < definition.node; ++possible) {
    mentioned.insert(possible->name);
  }
  return mentioned;
}

}  // namespace texbrdf
