#pragma once

#include <vector>

#include "semantics/body_view.h"
#include "semantics/operator_rules.h"

namespace texbrdf {

/// The one walk that gives types to the nodes of a body, bottom-up. A Domain says what a value is: one type with
/// reports (type_body.cpp), or the set of types it may still have (infer_parameters.cpp). It provides
///   Value exactly(Type), Value parameter(uint32_t position),
///   Value binary(NodeId, Operator, Value left, Value right),
///   Value elementary(NodeId, const Values&), Value tuple(NodeId, const Values&),
///   Value call(NodeId, const Signature&, const Values&),
///   Value length(Value operand), Value leaf(uint32_t slot), bool stopped()
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
    switch (node.kind) {
      case NodeKind::Number:
        return domain_.exactly(Type::Real);
      case NodeKind::VectorLiteral:
        return domain_.exactly(is_vector(id) ? Type::Vector : Type::Error);
      case NodeKind::Name:
        return name(id);
      case NodeKind::Group:
      case NodeKind::Prefix:
        return node.child_count == 1 ? child(id, 0, values) : domain_.exactly(Type::Error);
      case NodeKind::Tuple:
        return domain_.tuple(id, values);
      case NodeKind::Bars:
        return domain_.length(child(id, 0, values));
      case NodeKind::Angles:
        if (node.child_count == 1) return domain_.elementary(id, values);
        return domain_.binary(id, Operator::Multiply, child(id, 0, values), child(id, 1, values));
      case NodeKind::Fraction:
        return domain_.binary(id, Operator::Divide, child(id, 0, values), child(id, 1, values));
      case NodeKind::Infix:
        return binary(id, values);
      case NodeKind::Root:
      case NodeKind::Function:
      case NodeKind::Inverse:
      case NodeKind::Extremum:
        return domain_.elementary(id, values);
      case NodeKind::Apply:
        return apply(id, values);
      case NodeKind::Juxtaposition:
        return side_by_side(id, values);
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
    return domain_.binary(id, *op, child(id, 0, values), child(id, 1, values));
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
    if (callee.kind != Referent::Kind::Definition) return domain_.exactly(Type::Error);
    const Signature& signature = view_.facts.fact(NameId{callee.index}).signature;
    return signature.is_function ? domain_.call(id, signature, values) : domain_.exactly(Type::Error);
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
