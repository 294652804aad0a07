#include "emit/code.h"

#include <algorithm>
#include <utility>

namespace texbrdf::emit {
namespace {

constexpr uint32_t kWidest = 1'000'000;

/// Mixing && and || without parentheses is legal, but not what a careful person writes.
bool mixes_and_with_or(const Expression& user, const Expression& operand) {
  return user.precedence == Precedence::Or && operand.precedence == Precedence::And;
}

bool is_comparison(Precedence precedence) {
  return precedence == Precedence::Relational || precedence == Precedence::Equality;
}

}  // namespace

bool ExpressionPool::parenthesised(const Expression& user, uint32_t index) const {
  const Expression& operand = at(user.operands[index]);
  switch (user.kind) {
    case Expression::Kind::Atom:
    case Expression::Kind::Call:
      return false;
    case Expression::Kind::Member:
      return operand.precedence < Precedence::Primary;
    case Expression::Kind::Prefix:
      return operand.leading_minus ||
             operand.precedence < (user.text == "-" ? Precedence::Multiplicative : Precedence::Unary);
    case Expression::Kind::Conditional:
      return index == 0 && operand.precedence <= Precedence::Conditional;
    case Expression::Kind::Infix:
      break;
  }
  if (mixes_and_with_or(user, operand)) return true;
  if (index == 0)
    return operand.precedence < user.precedence ||
           (is_comparison(user.precedence) && operand.precedence == user.precedence);
  bool negative_factor = user.precedence == Precedence::Multiplicative && operand.precedence == Precedence::Unary;
  return (operand.leading_minus && !negative_factor) || operand.precedence <= user.precedence;
}

ExpressionId ExpressionPool::add(Expression expression) {
  uint32_t width = static_cast<uint32_t>(expression.text.size());
  uint32_t nesting = 0;
  for (uint32_t i = 0; i < expression.operands.size(); ++i) {
    const Expression& operand = at(expression.operands[i]);
    bool wrapped = parenthesised(expression, i);
    width += operand.width + (wrapped ? 2 : 0);
    nesting = std::max(nesting, operand.nesting + (wrapped ? 1 : 0));
  }
  switch (expression.kind) {
    case Expression::Kind::Atom:
    case Expression::Kind::Prefix:
      break;
    case Expression::Kind::Call:
      width += 2 + 2 * (expression.operands.empty() ? 0 : static_cast<uint32_t>(expression.operands.size()) - 1);
      ++nesting;
      break;
    case Expression::Kind::Member:
      width += 1;
      break;
    case Expression::Kind::Infix:
      width += 2;
      break;
    case Expression::Kind::Conditional:
      width += 6;
      ++nesting;
      break;
  }
  if (expression.kind == Expression::Kind::Infix || expression.kind == Expression::Kind::Conditional)
    expression.leading_minus = at(expression.operands[0]).leading_minus && !parenthesised(expression, 0);
  expression.width = std::min(width, kWidest);
  expression.nesting = nesting;
  expressions_.push_back(std::move(expression));
  return ExpressionId{static_cast<uint32_t>(expressions_.size() - 1)};
}

ExpressionId ExpressionPool::atom(std::string_view text) {
  return add({.kind = Expression::Kind::Atom, .text = std::string(text), .operands = {}});
}

ExpressionId ExpressionPool::call(std::string_view function, std::vector<ExpressionId> arguments) {
  return add({.kind = Expression::Kind::Call, .text = std::string(function), .operands = std::move(arguments)});
}

ExpressionId ExpressionPool::member(ExpressionId object, std::string_view name) {
  return add({.kind = Expression::Kind::Member, .text = std::string(name), .operands = {object}});
}

ExpressionId ExpressionPool::prefix(std::string_view op, ExpressionId operand) {
  // -(a * b) is (-a) * b to the last bit, so the parentheses can go.
  bool of_product = op == "-" && at(operand).precedence == Precedence::Multiplicative && !at(operand).leading_minus;
  return add({.kind = Expression::Kind::Prefix,
              .precedence = of_product ? Precedence::Multiplicative : Precedence::Unary,
              .leading_minus = op == "-",
              .text = std::string(op),
              .operands = {operand}});
}

ExpressionId ExpressionPool::infix(Precedence precedence, std::string_view op, ExpressionId left, ExpressionId right) {
  return add(
      {.kind = Expression::Kind::Infix, .precedence = precedence, .text = std::string(op), .operands = {left, right}});
}

ExpressionId ExpressionPool::conditional(ExpressionId condition, ExpressionId if_true, ExpressionId if_false) {
  return add({.kind = Expression::Kind::Conditional,
              .precedence = Precedence::Conditional,
              .text = {},
              .operands = {condition, if_true, if_false}});
}

}  // namespace texbrdf::emit
