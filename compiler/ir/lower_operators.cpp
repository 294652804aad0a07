#include <algorithm>
#include <array>

#include "ir/lower_builtin.h"
#include "ir/lowering.h"
#include "source/internal_error.h"

namespace texbrdf::ir {

namespace {

struct FunctionOp {
  Command command;
  Op op;
};

constexpr std::array kFunctionOps = {
    FunctionOp{Command::Exp, Op::Exp},       FunctionOp{Command::Ln, Op::Ln},
    FunctionOp{Command::Log, Op::Ln},        FunctionOp{Command::Sin, Op::Sin},
    FunctionOp{Command::Cos, Op::Cos},       FunctionOp{Command::Tan, Op::Tan},
    FunctionOp{Command::Arcsin, Op::Arcsin}, FunctionOp{Command::Arccos, Op::Arccos},
    FunctionOp{Command::Arctan, Op::Arctan}, FunctionOp{Command::Sinh, Op::Sinh},
    FunctionOp{Command::Cosh, Op::Cosh},     FunctionOp{Command::Tanh, Op::Tanh},
};

struct InfixOp {
  TokenKind token;
  Op op;
};

constexpr std::array kInfixOps = {
    InfixOp{TokenKind::Plus, Op::Add},          InfixOp{TokenKind::Minus, Op::Subtract},
    InfixOp{TokenKind::Multiply, Op::Multiply}, InfixOp{TokenKind::Cross, Op::Cross},
    InfixOp{TokenKind::Divide, Op::Divide},     InfixOp{TokenKind::Caret, Op::Power},
};

Op infix_op(TokenKind token) {
  const auto entry = std::find_if(kInfixOps.begin(), kInfixOps.end(),
                                  [token](const InfixOp& candidate) { return candidate.token == token; });
  require(entry != kInfixOps.end(), "an infix token that is no operator");
  return entry->op;
}

}  // namespace

Op function_op(Command function) {
  const auto entry = std::find_if(kFunctionOps.begin(), kFunctionOps.end(),
                                  [function](const FunctionOp& candidate) { return candidate.command == function; });
  require(entry != kFunctionOps.end(), "a function command without an op");
  return entry->op;
}

ValueId Lowering::infix(NodeId node) {
  const MatrixPower power = matrix_power_of(node);
  if (power != MatrixPower::None) return power_of_matrix(node, power);
  const ValueId left = child_value(node, 0), right = child_value(node, 1);
  const Op op = infix_op(token(node).kind);
  if (is_of_matrices(node)) return matrix_operation(node, op == Op::Cross ? Op::Multiply : op);
  if (op == Op::Multiply) return product(node, left, right);
  if (op == Op::Power && is_euler(left)) return graph_.add(Op::Exp, {right});
  if (op == Op::Cross) return graph_.add(is_cross_product(left, right) ? Op::Cross : Op::Multiply, {left, right});
  return graph_.add(op, {left, right});
}

bool Lowering::is_euler(ValueId id) const {
  const Value& value = graph_.at(id);
  return value.op == Op::Convention && value.index == static_cast<uint32_t>(Convention::Euler);
}

/// Of two vectors the dot product.
ValueId Lowering::product(NodeId node, ValueId left, ValueId right) {
  const bool is_dot = is_triple(graph_.at(left).type) && type(node) == Type::Real;
  return graph_.add(is_dot ? Op::Dot : Op::Multiply, {left, right});
}

bool Lowering::is_cross_product(ValueId left, ValueId right) const {
  const Type a = graph_.at(left).type, b = graph_.at(right).type;
  return is_triple(a) && is_triple(b) && a != Type::Colour && b != Type::Colour;
}

ValueId Lowering::bars(NodeId node) {
  const ValueId operand = child_value(node, 0);
  const Type operand_type = type(block_.tree.child(node, 0));
  if (is_aggregate(operand_type)) return length_of_matrix(matrix_of(operand, operand_type));
  const bool is_vector = is_triple(graph_.at(operand).type);
  return lower_builtin(graph_, is_vector ? Builtin::Length : Builtin::Abs, std::array{operand});
}

ValueId Lowering::angles(NodeId node) {
  if (is_of_matrices(node)) return matrix_product(node);
  if (block_.tree.node(node).child_count == 2) return product(node, child_value(node, 0), child_value(node, 1));
  return graph_.add(Op::Max, {graph_.constant(0), child_value(node, 0)});
}

ValueId Lowering::root(NodeId node) {
  if (block_.tree.node(node).child_count == 1) return graph_.add(Op::Sqrt, {child_value(node, 0)});
  return graph_.add(Op::Root, {child_value(node, 0), child_value(node, 1)});
}

ValueId Lowering::function(NodeId node) {
  const Command command = token(node).command;
  const ValueId operand = child_value(node, 0);
  if (command == Command::Det) return determinant(graph_, matrix_of(operand, type(block_.tree.child(node, 0))));
  if (block_.tree.node(node).child_count > 1) return add_logarithm(graph_, operand, child_value(node, 1));
  const auto of_operand = [&](Op op) { return graph_.add(op, {operand}); };
  if (command == Command::Lg) return lower_builtin(graph_, Builtin::Log10, std::array{operand});
  if (command == Command::Cot) return graph_.add(Op::Divide, {of_operand(Op::Cos), of_operand(Op::Sin)});
  if (command == Command::Sec) return graph_.add(Op::Divide, {graph_.constant(1), of_operand(Op::Cos)});
  if (command == Command::Csc) return graph_.add(Op::Divide, {graph_.constant(1), of_operand(Op::Sin)});
  return of_operand(function_op(command));
}

ValueId Lowering::extremum(NodeId node) {
  const Op op = token(node).command == Command::Max ? Op::Max : Op::Min;
  ValueId result = child_value(node, 0);
  for (const NodeId child : block_.tree.children(node).subspan(1)) result = graph_.add(op, {result, value(child)});
  return result;
}

}  // namespace texbrdf::ir
