#include "ir/lower.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <string>
#include <utility>

#include "ir/lower_builtin.h"
#include "ir/lowering.h"
#include "source/internal_error.h"
#include "syntax/control_words.h"
#include "syntax/relations.h"

namespace texbrdf::ir {

Lowering::Lowering(const ParsedBlock& block, const DefinitionSyntax& definition, const CheckedDefinition& checked,
                   Expressions expressions)
    : block_(block), definition_(definition), checked_(checked), expressions_(expressions) {
  const uint32_t count = definition.node.value + 1 - definition.first_node;
  values_.resize(count);
  needed_.resize(count);
  uint32_t formal = 0;
  for (const CheckedParameter& parameter : checked.parameters) {
    formals_.push_back(formal);
    formal += is_aggregate(parameter.type) ? type_components(parameter.type) : 1;
  }
}

Graph Lowering::run() {
  bound_.resize(checked_.bound.size());
  for (const InstanceCall& call : checked_.instance_calls) graph_.instances.push_back(call.instance);
  graph_.roots = {lower_tree(definition_.body, definition_.first_node)};
  return std::move(graph_);
}

/// All nodes of a tree whose names have values by now. The tree's nodes are [first, root].
ValueId Lowering::lower_tree(NodeId root, uint32_t first) {
  mark_needed(root, first);
  for (uint32_t i = first; i <= root.value; ++i) {
    if (needed_[slot({i})]) values_[slot({i})] = lower({i});
  }
  return value(root);
}

/// The tree's nodes, without the names of called functions. What a binder is taken of is lowered with it, perhaps
/// several times.
void Lowering::mark_needed(NodeId root, uint32_t first) {
  std::fill(needed_.begin() + static_cast<std::ptrdiff_t>(slot({first})),
            needed_.begin() + static_cast<std::ptrdiff_t>(slot(root)) + 1, false);
  needed_[slot(root)] = true;
  for (uint32_t i = root.value + 1; i-- > first;) {
    if (!needed_[slot({i})] || is_argument({i})) continue;
    for (const NodeId child : lowered_before({i})) needed_[slot(child)] = true;
  }
}

std::span<const NodeId> Lowering::lowered_before(NodeId node) const {
  const std::span<const NodeId> children = block_.tree.children(node);
  switch (block_.tree.node(node).kind) {
    case NodeKind::Apply:
      return children.subspan(1);
    case NodeKind::Infix:
      return matrix_power_of(node) == MatrixPower::None ? children : children.first(1);
    case NodeKind::BigOperator:
      return children.subspan(1, 1);
    case NodeKind::Integral:
      return children.first(1);
    case NodeKind::Derivative:
      return children.subspan(1, 1);
    default:
      return children;
  }
}

/// The node says an expression that is a parameter.
bool Lowering::is_argument(NodeId node) const {
  if (block_.tree.node(node).kind == NodeKind::Name || referent(node).kind != Referent::Kind::Parameter) return false;
  const bool has_name = checked_.parameters[referent(node).index].name.valid();
  return has_name || expressions_ == Expressions::AreArguments;
}

ValueId Lowering::lower(NodeId node) {
  if (is_argument(node)) return formal(referent(node).index);
  switch (block_.tree.node(node).kind) {
    case NodeKind::Number:
      return graph_.constant(number(node));
    case NodeKind::Name:
      return name(node);
    case NodeKind::Group:
      return child_value(node, 0);
    case NodeKind::Prefix:
      if (token(node).kind == TokenKind::Plus) return child_value(node, 0);
      if (is_aggregate(type(node))) return negated_matrix(node);
      return graph_.add(Op::Negate, {child_value(node, 0)});
    case NodeKind::Bars:
      return bars(node);
    case NodeKind::Angles:
      return angles(node);
    case NodeKind::Infix:
      return infix(node);
    case NodeKind::Juxtaposition:
      if (is_of_matrices(node)) return matrix_operation(node, Op::Multiply);
      return graph_.add(Op::Multiply, {child_value(node, 0), child_value(node, 1)});
    case NodeKind::Fraction:
      if (is_of_matrices(node)) return matrix_operation(node, Op::Divide);
      return graph_.add(Op::Divide, {child_value(node, 0), child_value(node, 1)});
    case NodeKind::Root:
      return root(node);
    case NodeKind::Function:
      return function(node);
    case NodeKind::Degrees:
      return lower_builtin(graph_, Builtin::Radians, std::array{child_value(node, 0)});
    case NodeKind::Inverse:
      return graph_.add(function_op(inverse_of(token(node).command)), {child_value(node, 0)});
    case NodeKind::Extremum:
      return extremum(node);
    case NodeKind::Apply:
      return call(node);
    case NodeKind::Matrix:
      return matrix(node);
    case NodeKind::MatrixRow:
      return {};
    case NodeKind::VectorLiteral:
    case NodeKind::Tuple:
      if (is_aggregate(type(node))) return matrix(node);
      return graph_.add(Op::MakeVector, {child_value(node, 0), child_value(node, 1), child_value(node, 2)});
    case NodeKind::BigOperator:
      return sum(node);
    case NodeKind::Integral:
      return integral(node);
    case NodeKind::Derivative:
      return derivative(node);
    case NodeKind::Range:
    case NodeKind::Set:
    case NodeKind::Domain:
      return {};
    case NodeKind::Differential:
      return graph_.constant(1);
    case NodeKind::Cases:
      return cases(node);
    case NodeKind::Case:
      return child_value(node, 0);
    case NodeKind::Comparison:
      return comparison(node);
    case NodeKind::Membership:
      return membership(node);
    case NodeKind::Junction:
      return graph_.add(is_conjunction(block_, node) ? Op::And : Op::Or, {child_value(node, 0), child_value(node, 1)});
    case NodeKind::Not:
      return graph_.add(Op::Not, {child_value(node, 0)});
    case NodeKind::Error:
    case NodeKind::Signature:
    case NodeKind::Definition:
      break;
  }
  throw InternalError("a node that has no value in a sound definition");
}

double Lowering::number(NodeId node) const {
  const std::string_view text = block_.node_text(node);
  double result = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
  // Beyond the range of double: zero or infinity, which std::strtod gives (the program stays in the C locale).
  if (error == std::errc::result_out_of_range) return std::strtod(std::string(text).c_str(), nullptr);
  require(error == std::errc{} && end == text.data() + text.size(), "a number token that is no number");
  return result;
}

Graph lower_definition(const ParsedBlock& block, const DefinitionSyntax& definition, const BlockNames& /*names*/,
                       const CheckedDefinition& checked, Expressions expressions) {
  require(checked.sound, "lower_definition of a definition that is not sound");
  return Lowering(block, definition, checked, expressions).run();
}

}  // namespace texbrdf::ir
