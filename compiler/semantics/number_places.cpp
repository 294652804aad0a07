#include "semantics/number_places.h"

#include "syntax/matrix_power.h"

namespace texbrdf {

bool NumberPlaces::is_number(NameId name) {
  if (view_.table.text(name).size() != 1) return false;
  if (!is_found_) find();
  return numbers_.find(name).has_value();
}

void NumberPlaces::find() {
  is_found_ = true;
  for (uint32_t node = view_.body_begin(); node < view_.body_end(); ++node) read(NodeId{node});
}

void NumberPlaces::read(NodeId id) {
  const Node& node = view_.node(id);
  const std::span<const NodeId> children = view_.block.tree.children(id);
  switch (node.kind) {
    case NodeKind::Root:
    case NodeKind::Function:
    case NodeKind::Degrees:
    case NodeKind::Inverse:
    case NodeKind::Extremum:
    case NodeKind::Comparison:
    case NodeKind::Membership:
      for (const NodeId operand : children) add(operand);
      return;
    case NodeKind::Fraction:
      if (children.size() == 2) add(children[1]);
      return;
    case NodeKind::Infix:
      if (children.size() == 2 && matrix_power(view_.block, id) == MatrixPower::None) {
        read_operation(view_.token(node.token).kind, children[0], children[1]);
      }
      return;
    case NodeKind::Number:
    case NodeKind::Name:
    case NodeKind::Group:
    case NodeKind::Tuple:
    case NodeKind::Matrix:
    case NodeKind::MatrixRow:
    case NodeKind::Bars:
    case NodeKind::Angles:
    case NodeKind::Prefix:
    case NodeKind::Apply:
    case NodeKind::VectorLiteral:
    case NodeKind::Juxtaposition:
    case NodeKind::Cases:
    case NodeKind::Case:
    case NodeKind::Junction:
    case NodeKind::Not:
    case NodeKind::BigOperator:
    case NodeKind::Integral:
    case NodeKind::Derivative:
    case NodeKind::Range:
    case NodeKind::Set:
    case NodeKind::Domain:
    case NodeKind::Differential:
    case NodeKind::Error:
    case NodeKind::Signature:
    case NodeKind::Definition:
      return;
  }
}

void NumberPlaces::read_operation(TokenKind op, NodeId left, NodeId right) {
  if (op == TokenKind::Caret) add(left);
  if (op == TokenKind::Caret || op == TokenKind::Divide) add(right);
  if (op != TokenKind::Plus && op != TokenKind::Minus) return;
  read_sum(left, right);
  read_sum(right, left);
}

void NumberPlaces::read_sum(NodeId left, NodeId right) {
  if (view_.node(view_.without_groups(left)).kind == NodeKind::Number) add(right);
}

void NumberPlaces::add(NodeId operand) {
  operand = view_.without_groups(operand);
  if (view_.node(operand).kind == NodeKind::Name && view_.name(operand).valid()) numbers_.insert(view_.name(operand));
}

}  // namespace texbrdf
