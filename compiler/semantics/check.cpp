#include "semantics/check.h"

#include <algorithm>
#include <iterator>
#include <unordered_set>

#include "semantics/body_view.h"
#include "semantics/infer_parameters.h"
#include "semantics/parameter.h"
#include "semantics/resolve.h"
#include "semantics/type_body.h"

namespace texbrdf {
namespace {

bool has_error(const std::vector<Diagnostic>& diagnostics) {
  return std::ranges::any_of(diagnostics, [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

class DefinitionCheck {
 public:
  explicit DefinitionCheck(const DefinitionView& view) : view_(view) {}

  CheckedDefinition run() {
    checked_.name = view_.name(view_.syntax.name);
    body_ = resolve_names(view_, checked_);
    TypedBody typed = read_body();
    checked_.types = std::move(typed.types);
    checked_.spread_arguments = std::move(typed.spread_arguments);
    if (view_.syntax.readable) append(std::move(typed.diagnostics));
    checked_.sound = !is_faulty() && !typed.holds_unknown;
    finish();
    return std::move(checked_);
  }

 private:
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

  TypedBody read_body() {
    const std::vector<uint32_t> bold = bold_parameters();
    TypedBody typed = read_as_spelled(bold.empty());
    const bool fits = typed.diagnostics.empty();
    if (bold.empty() || fits || is_faulty()) return typed;
    for (const uint32_t position : bold) checked_.parameters[position].type = Type::Error;
    Reading best = best_reading(parameter_types());
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
    return std::ranges::any_of(body_.referents, [&](const Referent& referent) {
      return referent.kind == Referent::Kind::Angle && angle_of_parameter(referent).position == position;
    });
  }

  TypedBody read_as_spelled(bool is_last_reading) {
    const std::vector<Type> known = parameter_types();
    if (!has_open_parameters()) {
      return type_body(view_, body_, is_last_reading ? std::move(body_.leaves) : body_.leaves, known);
    }
    if (is_faulty()) return read_as(known).body;
    Reading best = best_reading(known);
    if (best.is_certain()) {
      decide(best.parameters);
      checked_.signature.spreads = spread_parameters(best.parameters);
      return std::move(best.body);
    }
    // A body that is in error, or holds what is, says nothing about its parameters.
    TypedBody undecided = read_as(known).body;
    undecided.diagnostics = std::move(best.body.diagnostics);
    return undecided;
  }

  Reading read_as(std::vector<Type> parameters) const {
    TypedBody body = type_body(view_, body_, body_.leaves, parameters);
    return {std::move(parameters), std::move(body)};
  }

  /// One that fits, or the one whose faults are told.
  Reading best_reading(const std::vector<Type>& known) const {
    std::vector<Type> all_real = known;
    std::ranges::replace(all_real, Type::Error, Type::Real);
    Reading real = read_as(std::move(all_real));
    if (real.fits() && !holds_times()) return real;
    Reading undecided = read_as(known);
    if (!undecided.fits()) return real.fits() ? real : undecided;
    std::optional<std::vector<Type>> inferred = infer_parameters(view_, body_, known);
    return inferred ? read_as(*std::move(inferred)) : real;
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
      const Reading reading = read_as(std::move(with_colour));
      const Type result = reading.body.types[view_.slot(view_.syntax.body)];
      if (reading.is_certain() && result == Type::Colour) found |= uint64_t{1} << i;
    }
    return found;
  }

  void decide(const std::vector<Type>& types) {
    for (size_t i = 0; i < types.size(); ++i) {
      CheckedParameter& parameter = checked_.parameters[i];
      parameter.type = types[i];
      if (parameter.inferred && types[i] == Type::Vector) hint_vector(parameter);
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
    signature.is_function = view_.node(view_.syntax.left).kind == NodeKind::Signature;
    signature.parameters = parameter_types();
    if (view_.syntax.readable) signature.result = result_type();
    if (signature.result == Type::Vector) signature.spreads = 0;
    if (checked_.sound) tell_colour_products();
    if (checked_.sound) hint_unused_parameters();
    checked_.referents = std::move(body_.referents);
    write_left_types();
    if (checked_.diagnostics.size() > kMaxReports) checked_.diagnostics.resize(kMaxReports, checked_.diagnostics[0]);
    const bool may_have_range = checked_.sound && !view_.block.comments.empty();
    if (may_have_range) parameter_literal(view_.block, view_.syntax, checked_.diagnostics);
  }

  Type result_type() const {
    const Type type = checked_.types[view_.slot(view_.syntax.body)];
    return type == Type::Tuple && is_written_as_vector() ? Type::Vector : type;
  }

  // Bold letters are colours too.
  bool is_written_as_vector() const {
    return view_.table.traits(checked_.name).is_vector && view_.block.node_text(view_.syntax.name).starts_with("\\vec");
  }

  void tell_colour_products() {
    for (uint32_t i = view_.body_begin(); i < view_.body_end(); ++i) {
      const Node& node = view_.node(NodeId{i});
      if (node.kind != NodeKind::Infix || view_.block.token_text(node.token) != "\\cdot") continue;
      const bool is_of_colours = std::ranges::all_of(view_.block.tree.children(NodeId{i}), [this](NodeId operand) {
        const Type type = checked_.types[view_.slot(operand)];
        return is_triple(type) && is_componentwise(type);
      });
      if (!is_of_colours) continue;
      const Location where = view_.at_token(node.token);
      checked_.diagnostics.push_back(make_diagnostic(Code::ColourProduct, where));
      checked_.diagnostics.back().fixes.push_back(
          {.title = "write `*`, a product by component", .edits = {{where, "*"}}});
    }
  }

  // Directions are what a BRDF takes, whether it needs them or not.
  void hint_unused_parameters() {
    std::vector<bool> is_used(checked_.parameters.size());
    for (uint32_t node = view_.body_begin(); node < view_.body_end(); ++node) {
      const Referent& referent = body_.referents[view_.slot(NodeId{node})];
      if (referent.kind == Referent::Kind::Parameter) is_used[referent.index] = true;
      if (referent.kind == Referent::Kind::Angle) is_used[angle_of_parameter(referent).position] = true;
    }
    for (size_t i = 0; i < is_used.size(); ++i) {
      const CheckedParameter& parameter = checked_.parameters[i];
      if (is_used[i] || !parameter.name.valid() || is_direction(view_.table.traits(parameter.name))) continue;
      checked_.diagnostics.push_back(
          make_diagnostic(Code::UnusedParameter, view_.at(parameter.node), {view_.name_text(parameter.node)}));
    }
  }

  static bool is_direction(const NameTraits& traits) {
    return traits.convention || (traits.usual_meaning && traits.is_vector);
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

}  // namespace texbrdf
