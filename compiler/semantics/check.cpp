#include "semantics/check.h"

#include <algorithm>
#include <iterator>
#include <unordered_set>

#include "semantics/ambiguities.h"
#include "semantics/body_view.h"
#include "semantics/infer_parameters.h"
#include "semantics/parameter.h"
#include "semantics/resolve.h"
#include "semantics/type_body.h"
#include "semantics/unread_arguments.h"

namespace texbrdf {
namespace {

bool has_error(const std::vector<Diagnostic>& diagnostics) {
  return std::ranges::any_of(diagnostics, [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

class DefinitionCheck {
 public:
  explicit DefinitionCheck(const DefinitionView& view) : view_(view) {}

  CheckedDefinition run() {
    read_names();
    checked_.signature.open = open_parameters();
    conclude(read_body());
    return std::move(checked_);
  }

  CheckedDefinition run_as(std::span<const Type> parameters) {
    read_names();
    const uint64_t open = open_parameters();
    if (!take_types(parameters)) return std::move(checked_);
    conclude(type_body(view_, body_, std::move(body_.leaves), parameter_types(), Calls::MayBeInstances));
    if (checked_.sound && multiplies_by_star(open)) checked_.sound = false;
    return std::move(checked_);
  }

 private:
  void read_names() {
    checked_.name = view_.name(view_.syntax.name);
    body_ = resolve_names(view_, checked_);
    take_unused_directions();
  }

  void conclude(TypedBody typed) {
    checked_.types = std::move(typed.types);
    checked_.spread_arguments = std::move(typed.spread_arguments);
    checked_.instance_calls = std::move(typed.instance_calls);
    if (view_.syntax.readable) append(std::move(typed.diagnostics));
    checked_.sound = !is_faulty() && !typed.holds_unknown;
    finish();
  }

  /// False where a parameter cannot be what is asked for.
  bool take_types(std::span<const Type> types) {
    if (types.size() != checked_.parameters.size()) return false;
    const uint64_t open = open_parameters();
    const std::vector<uint32_t> bold = bold_parameters();
    for (size_t i = 0; i < types.size(); ++i) {
      CheckedParameter& parameter = checked_.parameters[i];
      const bool is_open = i < 64 && ((open >> i) & 1) != 0;
      if (!is_open && parameter.type != Type::Error && types[i] != parameter.type) return false;
      if (std::ranges::find(bold, i) != bold.end() && type_components(types[i]) == 1) return false;
      parameter.type = types[i];
      parameter.inferred = false;
    }
    return true;
  }

  /// `a*x*x` is of numbers: with a vector for an open parameter, a dot product has to be written `\cdot`.
  bool multiplies_by_star(uint64_t open) const {
    for (uint32_t node = view_.body_begin(); node < view_.body_end(); ++node) {
      const Node& n = view_.node(NodeId{node});
      if (n.kind != NodeKind::Infix || view_.block.token_text(n.token) != "*") continue;
      const Type left = checked_.types[view_.slot(view_.block.tree.child(NodeId{node}, 0))];
      const bool is_dot_product = type_components(left) > 1 && checked_.types[view_.slot(NodeId{node})] == Type::Real;
      if (is_dot_product && holds_open_vector(NodeId{node}, open)) return true;
    }
    return false;
  }

  bool holds_open_vector(NodeId expression, uint64_t open) const {
    for (uint32_t node = expression.value; node-- > view_.body_begin();) {
      if (view_.node(NodeId{node}).first_token < view_.node(expression).first_token) return false;
      const Referent& referent = checked_.referents[view_.slot(NodeId{node})];
      if (referent.kind != Referent::Kind::Parameter || referent.index >= 64) continue;
      const bool is_open = ((open >> referent.index) & 1) != 0;
      if (is_open && type_components(checked_.parameters[referent.index].type) > 1) return true;
    }
    return false;
  }

  /// What is in bold may be anything but a number; a name that the convention gives a number is one.
  uint64_t open_parameters() const {
    uint64_t open = 0;
    const size_t count = std::min<size_t>(checked_.parameters.size(), 64);
    for (size_t i = 0; i < count; ++i) {
      const CheckedParameter& parameter = checked_.parameters[i];
      const bool is_open = parameter.inferred && parameter.type == Type::Error && !is_number_by_name(parameter.name);
      if (is_open) open |= uint64_t{1} << i;
    }
    for (const uint32_t position : bold_parameters()) {
      if (position < count) open |= uint64_t{1} << position;
    }
    return open;
  }

  bool is_number_by_name(NameId name) const {
    if (!name.valid()) return false;
    const std::optional<Convention> meaning = view_.table.traits(name).meaning();
    return meaning && convention_entry(*meaning).type == Type::Real;
  }

  /// The body under one choice of types for the parameters.
  struct Reading {
    std::vector<Type> parameters;
    TypedBody body;

    bool fits() const { return body.diagnostics.empty(); }
    bool is_certain() const { return fits() && !body.holds_unknown; }
  };

  bool is_faulty() const { return !view_.syntax.readable || has_error(checked_.diagnostics); }

  bool has_open_parameters() const {
    return std::ranges::any_of(checked_.parameters, [](const CheckedParameter& p) { return p.inferred; });
  }

  std::vector<Type> parameter_types() const {
    std::vector<Type> types;
    for (const CheckedParameter& parameter : checked_.parameters) types.push_back(parameter.type);
    return types;
  }

  /// What the body does not say the name does: `f_r(L, V)` takes two directions, whatever it makes of them.
  void take_unused_directions() {
    const std::vector<bool> is_used = used_parameters();
    for (size_t i = 0; i < is_used.size(); ++i) {
      CheckedParameter& parameter = checked_.parameters[i];
      const bool is_open = !is_used[i] && parameter.inferred && parameter.name.valid();
      if (!is_open || parameter.type != Type::Error || !is_usual_direction(parameter.name)) continue;
      parameter.type = Type::Vector;
      parameter.inferred = false;
    }
  }

  /// `v \cdot h` of parameters that papers call directions, or of one and a vector, is a product with numbers only
  /// where it has to be.
  std::vector<Type> with_multiplied_directions(std::vector<Type> types) const {
    for (uint32_t node = view_.body_begin(); node < view_.body_end(); ++node) {
      const Node& n = view_.node(NodeId{node});
      if (n.kind != NodeKind::Infix || view_.block.token_text(n.token) != "\\cdot") continue;
      const NodeId operands[] = {view_.block.tree.child(NodeId{node}, 0), view_.block.tree.child(NodeId{node}, 1)};
      const std::optional<uint32_t> left = open_direction(operands[0]);
      const std::optional<uint32_t> right = open_direction(operands[1]);
      if (left && (right || is_name_of_vector(operands[1]))) types[*left] = Type::Vector;
      if (right && (left || is_name_of_vector(operands[0]))) types[*right] = Type::Vector;
    }
    return types;
  }

  bool is_name_of_vector(NodeId node) const {
    const NodeId name = view_.without_groups(node);
    if (view_.node(name).kind != NodeKind::Name) return false;
    const Referent& referent = body_.referents[view_.slot(name)];
    if (referent.kind == Referent::Kind::Parameter) return checked_.parameters[referent.index].type == Type::Vector;
    return body_.leaves[view_.slot(name)] == Type::Vector;
  }

  /// The parameter that the node names, where its type is open and its name that of a direction.
  std::optional<uint32_t> open_direction(NodeId node) const {
    const Referent& referent = body_.referents[view_.slot(view_.without_groups(node))];
    if (referent.kind != Referent::Kind::Parameter) return std::nullopt;
    const CheckedParameter& parameter = checked_.parameters[referent.index];
    const bool is_open = parameter.inferred && parameter.name.valid();
    return is_open && is_usual_direction(parameter.name) ? std::optional(referent.index) : std::nullopt;
  }

  /// The frame's are none that a function of directions is given.
  bool is_usual_direction(NameId name) const {
    const std::optional<Convention> meaning = view_.table.traits(name).usual_meaning;
    return meaning && convention_entry(*meaning).type == Type::Vector && *meaning != Convention::Tangent &&
           *meaning != Convention::Bitangent;
  }

  std::vector<bool> used_parameters() const {
    std::vector<bool> is_used(checked_.parameters.size());
    for (uint32_t node = view_.body_begin(); node < view_.body_end(); ++node) {
      note_use(body_.referents[view_.slot(NodeId{node})], is_used);
    }
    const auto use = [&](const TypedReferent& used) { note_use(used.referent, is_used); };
    for (const DerivedNumber& derived : checked_.derived) use(derived.vector);
    for (const ImpliedCall& call : checked_.implied_calls) std::ranges::for_each(call.arguments, use);
    return is_used;
  }

  static void note_use(const Referent& referent, std::vector<bool>& is_used) {
    if (referent.kind == Referent::Kind::Parameter) is_used[referent.index] = true;
    if (referent.kind == Referent::Kind::Angle) is_used[angle_of_parameter(referent).position] = true;
  }

  /// Functions are what they read as by themselves, unless nothing fits them so.
  TypedBody read_body() {
    const std::vector<uint32_t> bold = bold_parameters();
    if (!has_open_parameters() && bold.empty()) {
      return type_body(view_, body_, std::move(body_.leaves), parameter_types(), Calls::MayBeInstances);
    }
    if (!calls_open_functions()) return read_parameters(bold, Calls::AsDefined);
    if (!is_faulty()) {
      if (std::optional<TypedBody> typed = read_with_handed_directions()) return *std::move(typed);
      TypedBody typed = read_parameters(bold, Calls::AsDefined);
      if (typed.diagnostics.empty() && !typed.holds_unknown) return typed;
    }
    return read_parameters(bold, Calls::MayBeInstances);
  }

  /// What a BRDF has of papers' directions it hands on as such, wherever that makes sense: `f_r(l, v) = g(l, v)`.
  std::optional<TypedBody> read_with_handed_directions() {
    if (!view_.table.traits(checked_.name).may_be_brdf) return std::nullopt;
    std::vector<Type> types = parameter_types();
    for (uint32_t node = view_.body_begin(); node < view_.body_end(); ++node) {
      if (view_.node(NodeId{node}).kind != NodeKind::Apply) continue;
      for (const NodeId argument : view_.block.tree.children(NodeId{node}).subspan(1)) {
        if (const std::optional<uint32_t> position = open_direction(argument)) types[*position] = Type::Vector;
      }
    }
    if (types == parameter_types()) return std::nullopt;
    Reading best = best_reading(types, Calls::MayBeInstances);
    if (!best.is_certain()) return std::nullopt;
    decide(best.parameters);
    return std::move(best.body);
  }

  bool calls_open_functions() const {
    return std::ranges::any_of(body_.referents, [&](const Referent& referent) {
      return referent.kind == Referent::Kind::Definition && referent.index != checked_.name.value &&
             view_.facts.fact(NameId{referent.index}).signature.open != 0;
    });
  }

  TypedBody read_parameters(const std::vector<uint32_t>& bold, Calls calls) {
    TypedBody typed = read_as_spelled(calls);
    const bool fits = typed.diagnostics.empty();
    if (bold.empty() || fits || is_faulty()) return typed;
    for (const uint32_t position : bold) checked_.parameters[position].type = Type::Error;
    Reading best = best_reading(parameter_types(), calls);
    if (!best.is_certain()) {
      for (const uint32_t position : bold) checked_.parameters[position].type = Type::Vector;
      return typed;
    }
    decide(best.parameters);
    return std::move(best.body);
  }

  /// A `\vec` is a vector always, and so is what papers call a direction; other decorations may be of a number too.
  std::vector<uint32_t> bold_parameters() const {
    std::vector<uint32_t> bold;
    for (uint32_t i = 0; i < checked_.parameters.size(); ++i) {
      const CheckedParameter& parameter = checked_.parameters[i];
      const bool is_free = parameter.type == Type::Vector && parameter.shadowed.empty() && !has_angle(i);
      const bool is_decorated =
          is_free && view_.table.traits(parameter.name).is_vector && !view_.table.traits(parameter.name).usual_meaning;
      if (is_decorated && !view_.block.node_text(parameter.node).starts_with("\\vec")) bold.push_back(i);
    }
    return bold;
  }

  bool has_angle(uint32_t position) const {
    const auto is_of_parameter = [&](const DerivedNumber& derived) {
      return derived.vector.referent == Referent{Referent::Kind::Parameter, position};
    };
    if (std::ranges::any_of(checked_.derived, is_of_parameter)) return true;
    return std::ranges::any_of(body_.referents, [&](const Referent& referent) {
      return referent.kind == Referent::Kind::Angle && angle_of_parameter(referent).position == position;
    });
  }

  TypedBody read_as_spelled(Calls calls) {
    const std::vector<Type> known = parameter_types();
    if (!has_open_parameters() || is_faulty()) return read_as(known, calls).body;
    const std::vector<Type> directed = with_multiplied_directions(known);
    Reading best = best_reading(directed, calls);
    if (directed != known && !best.is_certain()) best = best_reading(known, calls);
    if (best.is_certain()) {
      decide(best.parameters);
      checked_.signature.spreads = spread_parameters(best.parameters);
      return std::move(best.body);
    }
    // A body that is in error, or holds what is, says nothing about its parameters.
    TypedBody undecided = read_as(known, calls).body;
    undecided.diagnostics = std::move(best.body.diagnostics);
    return undecided;
  }

  Reading read_as(std::vector<Type> parameters, Calls calls) const {
    TypedBody body = type_body(view_, body_, body_.leaves, parameters, calls);
    return {std::move(parameters), std::move(body)};
  }

  /// One that fits, or the one whose faults are told.
  Reading best_reading(const std::vector<Type>& known, Calls calls) const {
    std::vector<Type> all_real = known;
    std::ranges::replace(all_real, Type::Error, Type::Real);
    Reading real = read_as(std::move(all_real), calls);
    if (real.fits() && !holds_times()) return real;
    Reading undecided = read_as(known, calls);
    if (!undecided.fits()) return real.fits() ? real : undecided;
    std::optional<std::vector<Type>> inferred = infer_parameters(view_, body_, known, calls);
    return inferred ? read_as(*std::move(inferred), calls) : real;
  }

  /// Which is the product of two vectors sooner than of numbers.
  bool holds_times() const {
    for (uint32_t node = view_.body_begin(); node < view_.body_end(); ++node) {
      const Node& n = view_.node(NodeId{node});
      if (n.kind == NodeKind::Infix && view_.token(n.token).kind == TokenKind::Cross) return true;
    }
    return false;
  }

  /// Those that the body takes component by component where they are colours. What it makes of several colours follows
  /// from what it makes of each: wherever one may stand beside a real it may stand beside another.
  uint64_t spread_parameters(const std::vector<Type>& types) const {
    uint64_t found = 0;
    const size_t count = std::min<size_t>(types.size(), 64);
    if (count * view_.slot_count() > kMaxInferenceSteps) return found;
    for (size_t i = 0; i < count; ++i) {
      if (!checked_.parameters[i].inferred || types[i] != Type::Real) continue;
      std::vector<Type> with_colour = types;
      with_colour[i] = Type::Colour;
      const Reading reading = read_as(std::move(with_colour), Calls::AsDefined);
      const Type result = reading.body.types[view_.slot(view_.syntax.body)];
      if (reading.is_certain() && result == Type::Colour) found |= uint64_t{1} << i;
    }
    return found;
  }

  void decide(const std::vector<Type>& types) {
    for (size_t i = 0; i < types.size(); ++i) {
      CheckedParameter& parameter = checked_.parameters[i];
      parameter.type = types[i];
      const bool is_surprising = parameter.inferred && parameter.name.valid() && types[i] == Type::Vector;
      if (is_surprising && !checked_.signature.has_implied_parameters) hint_vector(parameter);
    }
  }

  void hint_vector(const CheckedParameter& parameter) {
    const std::string name = view_.name_text(parameter.node);
    const std::string spelling = "\\vec{" + name + "}";
    Diagnostic diagnostic = make_diagnostic(Code::VectorParameter, view_.at(parameter.node), {name, spelling});
    Fix fix{.title = "write `" + spelling + "`", .edits = {}};
    for (uint32_t node = view_.syntax.first_node; node < view_.body_end(); ++node) {
      if (view_.name(NodeId{node}) != parameter.name) continue;
      const Location where = view_.at(NodeId{node});
      fix.edits.push_back({where, "\\vec{" + std::string(view_.block.slice(where.span)) + "}"});
    }
    diagnostic.fixes.push_back(std::move(fix));
    checked_.diagnostics.push_back(std::move(diagnostic));
  }

  // A name that is undefined where an operator is missing is one problem, and an unknown command is the cause of it.
  void append(std::vector<Diagnostic> found) {
    const std::unordered_set<uint32_t> gaps = places(found, Code::MissingOperator);
    if (!gaps.empty()) {
      const std::unordered_set<uint32_t> commands = places(checked_.diagnostics, Code::UnknownCommand);
      erase_at(found, Code::MissingOperator, commands);
      erase_at(checked_.diagnostics, Code::UndefinedName, gaps);
    }
    std::ranges::move(found, std::back_inserter(checked_.diagnostics));
  }

  static std::unordered_set<uint32_t> places(const std::vector<Diagnostic>& diagnostics, Code code) {
    std::unordered_set<uint32_t> found;
    for (const Diagnostic& diagnostic : diagnostics) {
      if (diagnostic.code == code) found.insert(diagnostic.where.span.begin);
    }
    return found;
  }

  static void erase_at(std::vector<Diagnostic>& diagnostics, Code code, const std::unordered_set<uint32_t>& begins) {
    std::erase_if(diagnostics,
                  [&](const Diagnostic& d) { return d.code == code && begins.contains(d.where.span.begin); });
  }

  void finish() {
    Signature& signature = checked_.signature;
    signature.is_function = view_.node(view_.syntax.left).kind == NodeKind::Signature || !checked_.parameters.empty();
    signature.parameters = parameter_types();
    if (view_.syntax.readable) signature.result = result_type();
    if (signature.result == Type::Vector || is_aggregate(signature.result)) signature.spreads = 0;
    if (checked_.sound) check_implied_calls();
    if (checked_.sound) signature.unread = unread_parameters(view_, checked_, body_.referents);
    if (checked_.sound) hint_unused_parameters();
    checked_.referents = std::move(body_.referents);
    checked_.bound = std::move(body_.bound);
    checked_.indexed = std::move(body_.indexed);
    if (checked_.sound) tell_ambiguities(view_, checked_);
    write_left_types();
    if (checked_.diagnostics.size() > kMaxReports) checked_.diagnostics.resize(kMaxReports, checked_.diagnostics[0]);
    const bool may_have_range = checked_.sound && !view_.block.comments.empty();
    if (may_have_range) parameter_literal(view_.block, view_.syntax, checked_.diagnostics);
  }

  /// What parameters are is known only now.
  void check_implied_calls() {
    for (ImpliedCall& call : checked_.implied_calls) {
      const Signature& signature = view_.facts.fact(view_.name(call.node)).signature;
      for (size_t i = 0; i < call.arguments.size(); ++i) {
        TypedReferent& argument = call.arguments[i];
        if (argument.referent.kind != Referent::Kind::Parameter) continue;
        argument.type = checked_.parameters[argument.referent.index].type;
        if (fits(argument.type, signature.parameters[i])) continue;
        checked_.diagnostics.push_back(
            make_diagnostic(Code::FunctionAsValue, view_.at(call.node), {view_.name_text(call.node)}));
        checked_.sound = false;
      }
    }
  }

  Type result_type() const {
    const Type type = checked_.types[view_.slot(view_.syntax.body)];
    return type == Type::Tuple && is_written_as_vector() ? Type::Vector : type;
  }

  // Bold letters are colours too.
  bool is_written_as_vector() const {
    return view_.table.traits(checked_.name).is_vector && view_.block.node_text(view_.syntax.name).starts_with("\\vec");
  }

  // Directions are what a BRDF takes, whether it needs them or not.
  void hint_unused_parameters() {
    const std::vector<bool> is_used = used_parameters();
    for (size_t i = 0; i < is_used.size(); ++i) {
      const CheckedParameter& parameter = checked_.parameters[i];
      if (is_used[i] || !parameter.name.valid() || is_direction(parameter)) continue;
      checked_.diagnostics.push_back(
          make_diagnostic(Code::UnusedParameter, view_.at(parameter.node), {view_.name_text(parameter.node)}));
    }
  }

  bool is_direction(const CheckedParameter& parameter) const {
    const NameTraits& traits = view_.table.traits(parameter.name);
    const bool is_usual = traits.usual_meaning && (traits.is_vector || parameter.type == Type::Vector);
    return traits.convention || is_usual;
  }

  void write_left_types() {
    checked_.types[view_.slot(view_.syntax.name)] = checked_.signature.result;
    checked_.types[view_.slot(view_.syntax.left)] = checked_.signature.result;
    checked_.types[view_.slot(view_.syntax.node)] = checked_.signature.result;
    for (const CheckedParameter& parameter : checked_.parameters) {
      checked_.types[view_.slot(parameter.node)] = parameter.type;
    }
  }

  const DefinitionView& view_;
  CheckedDefinition checked_;
  ResolvedBody body_;
};

}  // namespace

CheckedDefinition check_definition(const ParsedBlock& block, const DefinitionSyntax& definition,
                                   const BlockNames& names, const NameTable& table, const Facts& facts) {
  const DefinitionView view{block, definition, names, table, facts};
  return DefinitionCheck(view).run();
}

CheckedDefinition check_instance(const ParsedBlock& block, const DefinitionSyntax& definition, const BlockNames& names,
                                 const NameTable& table, const Facts& facts, std::span<const Type> parameters) {
  const DefinitionView view{block, definition, names, table, facts};
  return DefinitionCheck(view).run_as(parameters);
}

}  // namespace texbrdf
