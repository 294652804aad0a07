#include <algorithm>
#include <array>

#include "ir/lowering.h"
#include "ir/matrix_algebra.h"
#include "semantics/matrix_rules.h"
#include "source/internal_error.h"

namespace texbrdf::ir {
namespace {

constexpr std::array kFrame = {Convention::Tangent, Convention::Bitangent, Convention::Normal};

}  // namespace

/// A vector's are its components in the tangent frame, as `v_x` is; those of a tuple and of a colour are its numbers.
MatrixValue Lowering::matrix_of(ValueId id, Type type) {
  MatrixValue matrix{type_shape(type), {}};
  for (uint32_t i = 0; i < matrix.shape.entries(); ++i) {
    if (is_aggregate(type)) {
      matrix.entries.push_back(entry(id, i));
    } else if (type == Type::Vector) {
      matrix.entries.push_back(graph_.add(Op::Dot, {id, convention(kFrame[i])}));
    } else if (is_triple(type)) {
      matrix.entries.push_back(graph_.add(Op::Component, {id}, i));
    } else {
      matrix.entries.push_back(id);
    }
  }
  return matrix;
}

ValueId Lowering::value_of_matrix(const MatrixValue& matrix, Type type) {
  if (is_aggregate(type)) return graph_.leaf(Op::MakeMatrix, type, 0, matrix.entries);
  if (type == Type::Real) return matrix.entries[0];
  if (type != Type::Vector) return graph_.add(Op::MakeVector, matrix.entries);
  ValueId total;
  for (size_t i = 0; i < matrix.entries.size(); ++i) {
    const ValueId along = graph_.add(Op::Multiply, {matrix.entries[i], convention(kFrame[i])});
    total = total.valid() ? graph_.add(Op::Add, {total, along}) : along;
  }
  return total;
}

ValueId Lowering::entry(ValueId aggregate, uint32_t index) {
  const bool is_written = graph_.at(aggregate).op == Op::MakeMatrix;
  return is_written ? graph_.operand(aggregate, index) : graph_.add(Op::Entry, {aggregate}, index);
}

/// `(a, b)` or a matrix environment.
ValueId Lowering::matrix(NodeId node) {
  std::vector<ValueId> entries;
  for (const NodeId child : block_.tree.children(node)) {
    if (block_.tree.node(child).kind != NodeKind::MatrixRow) entries.push_back(value(child));
    if (block_.tree.node(child).kind != NodeKind::MatrixRow) continue;
    for (const NodeId cell : block_.tree.children(child)) entries.push_back(value(cell));
  }
  return value_of_matrix({type_shape(type(node)), entries}, type(node));
}

/// Whether what stands above the base makes a matrix of it, and no power.
MatrixPower Lowering::matrix_power_of(NodeId node) const {
  const MatrixPower power = matrix_power(block_, node);
  if (power == MatrixPower::None) return power;
  const Type base = type(block_.tree.child(node, 0));
  NodeId exponent = block_.tree.child(node, 1);
  while (block_.tree.node(exponent).child_count == 1) exponent = block_.tree.child(exponent, 0);
  const bool has_sign = referent(exponent).kind == Referent::Kind::Transposition;
  return is_componentwise(base) && !has_sign ? MatrixPower::None : power;
}

ValueId Lowering::power_of_matrix(NodeId node, MatrixPower power) {
  MatrixValue matrix = matrix_of(child_value(node, 0), type(block_.tree.child(node, 0)));
  if (power != MatrixPower::Transposed) matrix = inverse(graph_, matrix);
  const bool stays_column = matrix.shape.is_vector() && matrix.shape == type_shape(type(node));
  if (power != MatrixPower::Inverse && !stays_column) matrix = transpose(matrix);
  return value_of_matrix(matrix, type(node));
}

bool Lowering::is_of_matrices(NodeId node) const {
  return std::ranges::any_of(block_.tree.children(node), [this](NodeId child) { return is_aggregate(type(child)); });
}

/// A sum, product or quotient.
ValueId Lowering::matrix_operation(NodeId node, Op op) {
  const NodeId first = block_.tree.child(node, 0), second = block_.tree.child(node, 1);
  const Type left = type(first), right = type(second);
  if (op == Op::Multiply && left != Type::Real && right != Type::Real) return matrix_product(node);
  const auto apply = [&](ValueId a, ValueId b) { return graph_.add(op, {a, b}); };
  if (left == Type::Real) {
    const auto scaled = [&](ValueId x) { return apply(value(first), x); };
    return value_of_matrix(map_entries(matrix_of(value(second), right), scaled), type(node));
  }
  const MatrixValue matrix = matrix_of(value(first), left);
  if (right == Type::Real) {
    return value_of_matrix(map_entries(matrix, [&](ValueId x) { return apply(x, value(second)); }), type(node));
  }
  return value_of_matrix(map_pairs(matrix, matrix_of(value(second), right), apply), type(node));
}

ValueId Lowering::matrix_product(NodeId node) {
  const NodeId first = block_.tree.child(node, 0), second = block_.tree.child(node, 1);
  const Type left = type(first), right = type(second);
  if (const auto vector = transposed_vector(first); vector && is_triple(right)) {
    return graph_.add(Op::Dot, {value(*vector), value(second)});
  }
  MatrixValue a = matrix_of(value(first), left);
  const MatrixValue b = matrix_of(value(second), right);
  const bool is_dot = type(node) == Type::Real && a.shape.is_vector() && b.shape.is_vector();
  if (is_dot) return dot(graph_, a, b);
  if (a.shape.columns != b.shape.rows) a = transpose(a);
  return value_of_matrix(ir::product(graph_, a, b), type(node));
}

/// The v of `v^T`, where it has three components.
std::optional<NodeId> Lowering::transposed_vector(NodeId node) const {
  while (block_.tree.node(node).kind == NodeKind::Group) node = block_.tree.child(node, 0);
  if (matrix_power_of(node) != MatrixPower::Transposed) return std::nullopt;
  const NodeId base = block_.tree.child(node, 0);
  return is_triple(type(base)) ? std::optional(base) : std::nullopt;
}

ValueId Lowering::negated_matrix(NodeId node) {
  const auto negate = [this](ValueId x) { return graph_.add(Op::Negate, {x}); };
  return value_of_matrix(map_entries(matrix_of(child_value(node, 0), type(node)), negate), type(node));
}

/// The length of a vector, the determinant of a matrix.
ValueId Lowering::length_of_matrix(const MatrixValue& matrix) {
  if (!matrix.shape.is_vector()) return determinant(graph_, matrix);
  return graph_.add(Op::Sqrt, {dot(graph_, matrix, matrix)});
}

ValueId Lowering::choice_of_matrices(ValueId condition, ValueId then, ValueId otherwise, Type type) {
  const auto choose = [&](ValueId a, ValueId b) { return graph_.add(Op::Select, {condition, a, b}); };
  return value_of_matrix(map_pairs(matrix_of(then, type), matrix_of(otherwise, type), choose), type);
}

/// A function that takes vectors of any length, or matrices.
ValueId Lowering::matrix_builtin(NodeId node, Builtin function) {
  std::vector<MatrixValue> arguments;
  for (const NodeId child : block_.tree.children(node).subspan(1)) {
    arguments.push_back(matrix_of(value(child), type(child)));
  }
  const MatrixValue& first = arguments[0];
  const auto scaled = [&](const MatrixValue& vector, ValueId factor) {
    return map_entries(vector, [&](ValueId x) { return graph_.add(Op::Multiply, {factor, x}); });
  };
  if (function == Builtin::Det) return determinant(graph_, first);
  if (function == Builtin::Trace) return trace(graph_, first);
  if (function == Builtin::Length) return length_of_matrix(first);
  if (function == Builtin::Dot) return dot(graph_, first, arguments[1]);
  if (function == Builtin::Normalize) {
    const ValueId length = length_of_matrix(first);
    const auto over = [&](ValueId x) { return graph_.add(Op::Divide, {x, length}); };
    return value_of_matrix(map_entries(first, over), type(node));
  }
  require(function == Builtin::Reflect, "a function of matrices that is not in the table");
  const ValueId along = dot(graph_, arguments[1], first);
  const ValueId twice = graph_.add(Op::Multiply, {graph_.constant(2), along});
  const auto subtract = [&](ValueId a, ValueId b) { return graph_.add(Op::Subtract, {a, b}); };
  return value_of_matrix(map_pairs(first, scaled(arguments[1], twice), subtract), type(node));
}

}  // namespace texbrdf::ir
