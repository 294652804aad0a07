#include <algorithm>

#include "ir/lowering.h"
#include "source/internal_error.h"
#include "syntax/relations.h"

namespace texbrdf::ir {

/// The first row whose condition holds; nothing but that one's value is evaluated.
ValueId Lowering::cases(NodeId node) {
  const std::span<const NodeId> rows = block_.tree.children(node);
  const auto rest = std::ranges::find_if(rows, [this](NodeId row) { return !has_condition(row); });
  // A real among colours is grey.
  const auto row = [&](NodeId id) { return add_spread(graph_, value(id), type(node)); };
  ValueId result = rest == rows.end() ? add_constant(graph_, 0, type(node)) : row(*rest);
  for (size_t i = rows.size(); i-- > 0;) {
    if (!has_condition(rows[i])) continue;
    const ValueId condition = child_value(rows[i], 1);
    const ValueId chosen = row(rows[i]);
    result = is_aggregate(type(node)) ? choice_of_matrices(condition, chosen, result, type(node))
                                      : graph_.add(Op::Select, {condition, chosen, result});
  }
  return result;
}

bool Lowering::has_condition(NodeId row) const {
  return block_.tree.node(row).child_count > 1;
}

ValueId Lowering::comparison(NodeId node) {
  ValueId all = relation(node, 0);
  for (uint32_t i = 1; i + 1 < block_.tree.node(node).child_count; ++i) {
    all = graph_.add(Op::And, {all, relation(node, i)});
  }
  return all;
}

/// Between operand `index` and the next.
ValueId Lowering::relation(NodeId node, uint32_t index) {
  const ValueId left = child_value(node, index);
  const ValueId right = child_value(node, index + 1);
  switch (read_relation(block_.token_text(relation_token(block_, node, index)))) {
    case Relation::Less:
      return graph_.add(Op::Less, {left, right});
    case Relation::LessEqual:
      return graph_.add(Op::LessEqual, {left, right});
    case Relation::Greater:
      return graph_.add(Op::Less, {right, left});
    case Relation::GreaterEqual:
      return graph_.add(Op::LessEqual, {right, left});
    case Relation::Equal:
      return graph_.add(Op::Equal, {left, right});
    case Relation::NotEqual:
      return graph_.add(Op::Not, {graph_.add(Op::Equal, {left, right})});
    case Relation::None:
    case Relation::Member:
      break;
  }
  throw InternalError("a relation that compares nothing in a sound definition");
}

/// `(0, 1]` leaves out its first end, and so does `]0, 1]`.
ValueId Lowering::membership(NodeId node) {
  const ValueId operand = child_value(node, 0);
  const TokenKind last = block_.tokens[block_.tree.node(node).end_token - 1].kind;
  require(last == TokenKind::CloseInterval, "an interval without its end in a sound definition");
  const bool holds_low = block_.token_text(block_.tree.node(node).token) == "[";
  const bool holds_high = block_.token_text(block_.tree.node(node).end_token - 1) == "]";
  return graph_.add(Op::And, {graph_.add(holds_low ? Op::LessEqual : Op::Less, {child_value(node, 1), operand}),
                              graph_.add(holds_high ? Op::LessEqual : Op::Less, {operand, child_value(node, 2)})});
}

}  // namespace texbrdf::ir
