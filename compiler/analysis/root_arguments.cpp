#include "analysis/root_arguments.h"

#include <algorithm>

#include "analysis/equation_text.h"
#include "ir/free_name.h"
#include "ir/lower.h"
#include "semantics/operator_rules.h"

namespace texbrdf {
namespace {

/// `x` is a position, which may stand there if the BRDF does not depend on it.
bool is_tangent(Convention meaning) {
  return meaning == Convention::Tangent || meaning == Convention::Bitangent;
}

/// The types of what the left side of a root is made of.
class LeftSide {
 public:
  LeftSide(const Snapshot::State& state, const LocatedDefinition& root)
      : state_(state), block_(root.at.parsed()), syntax_(root.syntax()), checked_(root.checked()) {}

  /// Of two names with an operator between, perhaps in bars; nothing where that makes no sense.
  std::optional<Type> type_of(NodeId expression) const {
    const Node& node = block_.tree.node(expression);
    const std::span<const NodeId> children = block_.tree.children(expression);
    if (node.kind == NodeKind::Name) return type_of_name(expression);
    if (node.kind == NodeKind::Infix) return type_of_operation(block_.tokens[node.token].kind, children);
    if (children.size() != 1) return std::nullopt;
    const std::optional<Type> inside = type_of(children[0]);
    if (node.kind == NodeKind::Group || !inside) return inside;
    return node.kind == NodeKind::Bars || *inside == Type::Real ? std::optional(Type::Real) : std::nullopt;
  }

 private:
  std::optional<Type> type_of_operation(TokenKind kind, std::span<const NodeId> operands) const {
    const std::optional<Operator> op = operator_of(kind);
    const std::optional<Type> left = type_of(operands[0]);
    const std::optional<Type> right = type_of(operands[1]);
    if (!op || !left || !right) return std::nullopt;
    return result(*op, *left, *right);
  }

  std::optional<Type> type_of_name(NodeId name) const {
    const Referent& referent = checked_.referents[name.value - syntax_.first_node];
    switch (referent.kind) {
      case Referent::Kind::Definition:
        return type_of_definition(NameId{referent.index});
      case Referent::Kind::Convention:
        return convention_entry(static_cast<Convention>(referent.index)).type;
      case Referent::Kind::Parameter:
        return checked_.parameters[referent.index].type;
      case Referent::Kind::Angle:
      case Referent::Kind::Derived:
        return Type::Real;
      case Referent::Kind::Builtin:
      case Referent::Kind::Bound:
      case Referent::Kind::BoundAngle:
      case Referent::Kind::Indexed:
      case Referent::Kind::Derivative:
      case Referent::Kind::Transposition:
      case Referent::Kind::None:
        return std::nullopt;
    }
    return std::nullopt;
  }

  std::optional<Type> type_of_definition(NameId name) const {
    const std::optional<DefinitionKey> key = state_.find(name);
    if (!key) return std::nullopt;
    const Signature& signature = state_.locate(*key).checked().signature;
    return signature.is_function ? std::nullopt : std::optional(signature.result);
  }

  const Snapshot::State& state_;
  const ParsedBlock& block_;
  const DefinitionSyntax& syntax_;
  const CheckedDefinition& checked_;
};

/// What the parameter means outside of the function.
std::optional<RootArgument> meaning_of(const Snapshot::State& state, const LocatedDefinition& root, uint32_t position) {
  const CheckedDefinition& checked = root.checked();
  const CheckedParameter& parameter = checked.parameters[position];
  if (!parameter.name.valid()) {
    const bool has_meaning = LeftSide(state, root).type_of(parameter.given) == parameter.type;
    return has_meaning ? std::optional<RootArgument>(std::monostate()) : std::nullopt;
  }
  if (const std::optional<DefinitionKey> key = state.find(parameter.name)) {
    const Signature& signature = state.locate(*key).checked().signature;
    if (signature.is_function || !fits(signature.result, parameter.type)) return std::nullopt;
    return parameter.name;
  }
  const std::optional<Convention> meaning = state.names->traits(parameter.name).meaning();
  if (!meaning || !fits(convention_entry(*meaning).type, parameter.type)) return std::nullopt;
  if (is_tangent(*meaning) && !checked.signature.is_unread(position)) return std::nullopt;
  return *meaning;
}

std::optional<RootArgument> argument_of(const Snapshot::State& state, const LocatedDefinition& root,
                                        uint32_t position) {
  const std::optional<RootArgument> meaning = meaning_of(state, root, position);
  const bool is_free = !meaning && may_be_anything(root.checked().signature, position);
  return is_free ? std::optional<RootArgument>(std::monostate()) : meaning;
}

ir::ValueId add_argument(ir::Graph& graph, const Snapshot::State& state, const RootArgument& argument, Type type) {
  if (const auto* convention = std::get_if<Convention>(&argument)) return graph.whole_convention(*convention);
  if (std::holds_alternative<std::monostate>(argument)) return ir::add_constant(graph, 0, type);
  const NameId name = std::get<NameId>(argument);
  const Type own = state.locate(*state.find(name)).checked().signature.result;
  return graph.leaf(ir::Op::Reference, own, name.value);
}

}  // namespace

bool may_be_anything(const Signature& signature, uint32_t position) {
  if (!signature.is_unread(position)) return false;
  const size_t count = signature.parameters.size();
  size_t first_read = 0;
  while (first_read < count && signature.is_unread(first_read)) ++first_read;
  const bool is_beside_two = count > 2 && first_read < count;
  return is_beside_two || std::ranges::count(signature.parameters, Type::Vector) >= 2;
}

std::optional<std::vector<RootArgument>> root_arguments(const Snapshot::State& state, const LocatedDefinition& root) {
  const CheckedDefinition& checked = root.checked();
  if (has_brdf_parameters(checked.signature)) return std::nullopt;
  std::vector<RootArgument> arguments;
  for (uint32_t i = 0; i < checked.parameters.size(); ++i) {
    const std::optional<RootArgument> argument = argument_of(state, root, i);
    if (!argument) return std::nullopt;
    arguments.push_back(*argument);
  }
  return arguments;
}

ir::LinkableDefinition call_of_root(const Snapshot::State& state, const LocatedDefinition& root, NameId function,
                                    const std::vector<RootArgument>& arguments) {
  const ParsedBlock& block = root.at.parsed();
  const CheckedDefinition& checked = root.checked();
  ir::LinkableDefinition call;
  call.id = ir::free_name(0);
  call.name = read_name(block, root.syntax().name);
  call.canonical = canonical_form(call.name);
  call.signature = {.is_function = false, .parameters = {}, .result = checked.signature.result};
  call.equation = one_line(block, root.syntax().left);

  std::vector<ir::ValueId> values;
  for (size_t i = 0; i < arguments.size(); ++i) {
    const ir::ValueId value = add_argument(call.graph, state, arguments[i], checked.signature.parameters[i]);
    const Command angle_of = checked.parameters[i].function;
    const bool is_angle = angle_of != Command::None && !std::holds_alternative<std::monostate>(arguments[i]);
    const Type type = call.graph.at(value).type;
    for (uint32_t k = 0; is_aggregate(type) && k < type_components(type); ++k) {
      values.push_back(call.graph.add(ir::Op::Entry, {value}, k));
    }
    if (is_aggregate(type)) continue;
    values.push_back(is_angle ? call.graph.add(ir::function_op(angle_of), {value}) : value);
  }
  call.graph.roots = {call.graph.leaf(ir::Op::Call, checked.signature.result, function.value, values)};
  return call;
}

}  // namespace texbrdf
