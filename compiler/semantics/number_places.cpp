#include "semantics/number_places.h"

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
    case NodeKind::Inverse:
    case NodeKind::Extremum:
      for (const NodeId operand : children) add(operand);
      return;
    case NodeKind::Fraction:
      if (children.size() == 2) add(children[1]);
      return;
    case NodeKind::Infix:
      if (children.size() != 2) return;
      switch (view_.token(node.token).kind) {
        case TokenKind::Caret:
          add(children[0]);
          return add(children[1]);
        case TokenKind::Divide:
          return add(children[1]);
        case TokenKind::Plus:
        case TokenKind::Minus:
          read_sum(children[0], children[1]);
          return read_sum(children[1], children[0]);
        default:
          return;
      }
    default:
      return;
  }
}

void NumberPlaces::read_sum(NodeId left, NodeId right) {
  if (view_.node(view_.without_groups(left)).kind == NodeKind::Number) add(right);
}

void NumberPlaces::add(NodeId operand) {
  operand = view_.without_groups(operand);
  if (view_.node(operand).kind == NodeKind::Name && view_.name(operand).valid()) numbers_.insert(view_.name(operand));
}

}  // namespace texbrdf
