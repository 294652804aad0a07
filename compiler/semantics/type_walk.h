#pragma once

#include <vector>

#include "semantics/body_view.h"
#include "semantics/builtin_functions.h"
#include "semantics/matrix_rules.h"
#include "syntax/matrix_power.h"

namespace texbrdf {

/// What `^T` makes of the base of a power. `(a, b)^T` is how papers write a column.
inline std::optional<Type> transposed_base(const DefinitionView& view, NodeId power, Type base) {
  const Node& node = view.node(view.block.tree.child(power, 0));
  const bool is_column = node.kind == NodeKind::Tuple && view.token(node.token).kind != TokenKind::OpenMatrix;
  return is_column ? std::optional(base) : transposed(base);
}

/// The one walk that gives types to the nodes of a body, bottom-up. A Domain says what a value is: one type with
/// reports (type_body.cpp), or the set of types it may still have (infer_parameters.cpp). It provides
///   Value exactly(Type), Value parameter(uint32_t position),
///   Value binary(NodeId, Operator, Value left, Value right),
///   Value elementary(NodeId, const Values&), Value tuple(NodeId, const Values&), Value matrix(NodeId, const Values&),
///   Value determinant(NodeId, Value operand), Value power_of_matrix(NodeId, MatrixPower, Value base, Value power),
///   Value builtin(NodeId, Builtin, const Values&), Value derivative_call(NodeId, const Signature&, const Values&),
///   Value call(NodeId, const Signature&, const Values&),
///   Value call_definition(NodeId, NameId function, const Signature&, const Values&),
///   Value bounds(NodeId, const Values&), Value reduction(NodeId, Value bounds, Value body),
///   Value derivative(NodeId, Value variable, Value body),
///   Value signed_value(NodeId, Value operand), Value length(NodeId, Value operand),
///   Value comparison(NodeId, const Values&), Value junction(NodeId, const Values&),
///   Value row(NodeId, const Values&), Value cases(NodeId, const Values&),
///   Value leaf(uint32_t slot), bool stopped()
/// where Values are all values so far by slot.
template <typename Domain>
class TypeWalk {
 public:
  using Value = typename Domain::Value;
  using Values = std::vector<Value>;

  TypeWalk(const DefinitionView& view, const ResolvedBody& body, Domain& domain)
      : view_(view), body_(body), domain_(domain) {}

  /// `values` has a place for each slot.
  void run(Values& values) {
    for (uint32_t i = view_.body_begin(); i < view_.body_end() && !domain_.stopped(); ++i) {
      const NodeId id{i};
      const bool is_skipped = !body_.skipped.empty() && body_.is_skipped(view_.node(id));
      values[view_.slot(id)] = is_skipped ? domain_.exactly(Type::Error) : value(id, values);
    }
  }

 private:
  Value value(NodeId id, const Values& values) {
    const Node& node = view_.node(id);
    const Referent& referent = body_.referents[view_.slot(id)];
    const bool is_argument = referent.kind == Referent::Kind::Parameter && node.kind != NodeKind::Name;
    if (is_argument) return domain_.parameter(referent.index);
    switch (node.kind) {
      case NodeKind::Number:
        return domain_.exactly(Type::Real);
      case NodeKind::VectorLiteral:
        return domain_.exactly(is_vector(id) ? Type::Vector : Type::Error);
      case NodeKind::Name:
        return name(id);
      case NodeKind::Group:
        return node.child_count == 1 ? child(id, 0, values) : domain_.exactly(Type::Error);
      case NodeKind::Prefix:
        return node.child_count == 1 ? domain_.signed_value(id, child(id, 0, values)) : domain_.exactly(Type::Error);
      case NodeKind::Tuple:
        return domain_.tuple(id, values);
      case NodeKind::Matrix:
        return domain_.matrix(id, values);
      case NodeKind::MatrixRow:
        return domain_.exactly(Type::Real);
      case NodeKind::Bars:
        return domain_.length(id, child(id, 0, values));
      case NodeKind::Angles:
        if (node.child_count == 1) return domain_.elementary(id, values);
        return domain_.binary(id, Operator::Multiply, child(id, 0, values), child(id, 1, values));
      case NodeKind::Fraction:
        return domain_.binary(id, Operator::Divide, child(id, 0, values), child(id, 1, values));
      case NodeKind::Infix:
        return binary(id, values);
      case NodeKind::Function:
        if (view_.token(node.token).command == Command::Det) return domain_.determinant(id, child(id, 0, values));
        return domain_.elementary(id, values);
      case NodeKind::Root:
      case NodeKind::Degrees:
      case NodeKind::Inverse:
      case NodeKind::Extremum:
        return domain_.elementary(id, values);
      case NodeKind::Apply:
        return apply(id, values);
      case NodeKind::BigOperator:
        return domain_.reduction(id, child(id, 1, values), child(id, 2, values));
      case NodeKind::Integral:
        return domain_.reduction(id, child(id, 0, values), child(id, 1, values));
      case NodeKind::Derivative:
        return domain_.derivative(id, child(id, 1, values), child(id, 0, values));
      case NodeKind::Range:
      case NodeKind::Set:
        return domain_.bounds(id, values);
      case NodeKind::Domain:
      case NodeKind::Differential:
        return domain_.exactly(Type::Real);
      case NodeKind::Juxtaposition:
        return side_by_side(id, values);
      case NodeKind::Comparison:
      case NodeKind::Membership:
        return domain_.comparison(id, values);
      case NodeKind::Junction:
      case NodeKind::Not:
        return domain_.junction(id, values);
      case NodeKind::Case:
        return domain_.row(id, values);
      case NodeKind::Cases:
        return domain_.cases(id, values);
      case NodeKind::Error:
      case NodeKind::Signature:
      case NodeKind::Definition:
        break;
    }
    return domain_.exactly(Type::Error);
  }

  const Value& child(NodeId id, uint32_t index, const Values& values) const {
    return values[view_.slot(view_.block.tree.child(id, index))];
  }

  Value name(NodeId id) {
    const Referent& referent = body_.referents[view_.slot(id)];
    const bool is_value = referent.kind == Referent::Kind::Parameter && !view_.is_callee(id);
    return is_value ? domain_.parameter(referent.index) : domain_.leaf(view_.slot(id));
  }

  Value binary(NodeId id, const Values& values) {
    const std::optional<Operator> op = operator_of(view_.token(view_.node(id).token).kind);
    if (!op || view_.node(id).child_count != 2) return domain_.exactly(Type::Error);
    const MatrixPower power = *op == Operator::Power ? matrix_power(view_.block, id) : MatrixPower::None;
    if (power == MatrixPower::None) return domain_.binary(id, *op, child(id, 0, values), child(id, 1, values));
    return domain_.power_of_matrix(id, power, child(id, 0, values), child(id, 1, values));
  }

  // What stands behind an unknown command or a word that lacks its backslash may be its operands.
  Value side_by_side(NodeId id, const Values& values) {
    const uint32_t second = view_.node(id).token;
    if (body_.is_skipped(second, second + 1) || follows_reserved_word(id)) return domain_.exactly(Type::Error);
    return domain_.binary(id, Operator::SideBySide, child(id, 0, values), child(id, 1, values));
  }

  bool follows_reserved_word(NodeId id) const {
    while (view_.node(id).kind == NodeKind::Juxtaposition) id = view_.block.tree.child(id, 0);
    const Token& last = view_.token(view_.node(id).end_token - 1);
    return last.kind == TokenKind::Word && is_reserved_word(view_.block.slice(last.span));
  }

  Value apply(NodeId id, const Values& values) {
    const Referent& callee = body_.referents[view_.slot(view_.block.tree.child(id, 0))];
    if (callee.kind == Referent::Kind::Builtin) {
      return domain_.builtin(id, static_cast<Builtin>(callee.index), values);
    }
    if (callee.kind == Referent::Kind::Indexed) return domain_.call(id, body_.indexed[callee.index].signature, values);
    const bool is_derivative = callee.kind == Referent::Kind::Derivative;
    if (callee.kind != Referent::Kind::Definition && !is_derivative) return domain_.exactly(Type::Error);
    const NameId function{callee.index};
    const Signature& signature = view_.facts.fact(function).signature;
    if (!signature.is_function) return domain_.exactly(Type::Error);
    return is_derivative ? domain_.derivative_call(id, signature, values)
                         : domain_.call_definition(id, function, signature, values);
  }

  // Whatever else stands in the literal is reported by the parser.
  bool is_vector(NodeId id) const {
    const std::span<const NodeId> elements = view_.block.tree.children(id);
    if (elements.size() != 3) return false;
    for (NodeId element : elements) {
      while (view_.node(element).kind == NodeKind::Prefix) element = view_.block.tree.child(element, 0);
      if (view_.node(element).kind != NodeKind::Number) return false;
    }
    return true;
  }

  const DefinitionView& view_;
  const ResolvedBody& body_;
  Domain& domain_;
};

}  // namespace texbrdf
