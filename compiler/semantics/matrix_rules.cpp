#include "semantics/matrix_rules.h"

namespace texbrdf {
namespace {

/// What is known of the result where the other operand may be anything.
std::optional<Type> beside_unknown(Operator op, Type left, Type right) {
  if (op == Operator::Plus || op == Operator::Minus) return left == Type::Error ? right : left;
  return op == Operator::Divide && right == Type::Error ? left : Type::Error;
}

/// Of a product whose rows and columns fit; a triple is of the kind of the one that is multiplied.
std::optional<Type> of_product(Shape shape, Type right) {
  const bool keeps_kind = shape == Shape{3, 1} && is_triple(right);
  return keeps_kind ? std::optional(right) : type_of_shape(shape);
}

std::optional<Type> product(Operator op, Type left, Type right) {
  if (left == Type::Real) return right;
  if (right == Type::Real) return left;
  if (left == Type::Colour || left == Type::Boolean || right == Type::Boolean) return std::nullopt;
  const Shape a = type_shape(left), b = type_shape(right);
  const bool is_dot = op == Operator::Multiply && a.is_vector() && b.is_vector() && a.entries() == b.entries();
  if (is_dot) return Type::Real;
  if (a.columns == b.rows) return of_product({a.rows, b.columns}, right);
  const bool is_row = a.columns == 1 && a.rows == b.rows && !b.is_vector();
  return is_row ? type_of_shape({1, b.columns}) : std::nullopt;
}

}  // namespace

std::optional<Type> matrix_result(Operator op, Type left, Type right) {
  if (left == Type::Error || right == Type::Error) return beside_unknown(op, left, right);
  switch (op) {
    case Operator::Plus:
    case Operator::Minus:
      return left == right ? std::optional(left) : std::nullopt;
    case Operator::Multiply:
    case Operator::SideBySide:
      return product(op, left, right);
    case Operator::Divide:
      return right == Type::Real ? std::optional(left) : std::nullopt;
    case Operator::Cross:
      return left == Type::Real || right == Type::Real ? product(op, left, right) : std::nullopt;
    case Operator::Power:
      return std::nullopt;
  }
  return std::nullopt;
}

std::optional<Type> tuple_type(size_t components) {
  const bool is_tuple = components > 1 && components <= kMaxRows;
  return is_tuple ? type_of_shape({static_cast<uint32_t>(components), 1}) : std::nullopt;
}

std::optional<Type> transposed(Type type) {
  const bool has_transpose = is_aggregate(type) || type == Type::Vector || type == Type::Tuple;
  if (!has_transpose) return std::nullopt;
  const Shape shape = type_shape(type);
  return type_of_shape({shape.columns, shape.rows});
}

bool is_square_matrix(Type type) {
  return is_aggregate(type) && type_shape(type).is_square();
}

bool is_column(Type type) {
  return (is_aggregate(type) || is_triple(type)) && type_shape(type).columns == 1;
}

}  // namespace texbrdf
