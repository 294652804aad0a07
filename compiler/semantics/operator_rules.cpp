#include "semantics/operator_rules.h"

#include <array>

#include "semantics/matrix_rules.h"

namespace texbrdf {
namespace {

constexpr auto kNeeds = std::to_array<std::string_view>({
#define OPERATOR(name, needs, matrix_needs) needs,
#include "semantics/operators.def"
#undef OPERATOR
});

constexpr auto kMatrixNeeds = std::to_array<std::string_view>({
#define OPERATOR(name, needs, matrix_needs) matrix_needs,
#include "semantics/operators.def"
#undef OPERATOR
});

struct Rule {
  Operator op;
  Type left, right, result;
};

constexpr auto kRules = std::to_array<Rule>({
#define OPERATOR_RULE(op, left, right, result) {Operator::op, Type::left, Type::right, Type::result},
#include "semantics/operator_rules.def"
#undef OPERATOR_RULE
});

constexpr auto kTypes = std::to_array<Type>({
#define TYPE(name, symbol, rows, columns) Type::name,
#include "semantics/types.def"
#undef TYPE
});

// No operator gives it.
constexpr Type kNoRule = Type::Boolean;

class ResultTable {
 public:
  constexpr ResultTable() {
    for (auto& by_left : of_) {
      for (auto& by_right : by_left) by_right.fill(kNoRule);
    }
    for (const Rule& rule : kRules) {
      for (Type left : {rule.left, Type::Error}) {
        for (Type right : {rule.right, Type::Error}) {
          Type& entry = at(rule.op, left, right);
          entry = entry == kNoRule ? rule.result : either(entry, rule.result, rule.op, left, right);
        }
      }
    }
    for (auto& by_left : of_) {
      for (Type known : kTypes) {
        forgive(by_left[static_cast<size_t>(known)][static_cast<size_t>(Type::Error)]);
        forgive(by_left[static_cast<size_t>(Type::Error)][static_cast<size_t>(known)]);
      }
    }
  }

  constexpr Type of(Operator op, Type left, Type right) const {
    return of_[static_cast<size_t>(op)][static_cast<size_t>(left)][static_cast<size_t>(right)];
  }

 private:
  constexpr Type& at(Operator op, Type left, Type right) {
    return of_[static_cast<size_t>(op)][static_cast<size_t>(left)][static_cast<size_t>(right)];
  }
  /// What is said of an unknown operand's result, where rules differ. To say more than is sure keeps an error from
  /// spreading over the document: beside a real stands a real sooner than a colour, and `\times` is between vectors.
  static constexpr Type either(Type a, Type b, Operator op, Type left, Type right) {
    if (a == b) return a;
    const bool beside_real = left == Type::Real || right == Type::Real;
    const bool are_real_or_colour = (a == Type::Real && b == Type::Colour) || (a == Type::Colour && b == Type::Real);
    if (beside_real && are_real_or_colour) return Type::Real;
    const bool are_unknown = left == Type::Error && right == Type::Error;
    return op == Operator::Cross && are_unknown ? Type::Vector : Type::Error;
  }
  // Beside an unknown operand nothing is a fault.
  static constexpr void forgive(Type& entry) {
    if (entry == kNoRule) entry = Type::Error;
  }

  std::array<std::array<std::array<Type, kTypes.size()>, kTypes.size()>, kNeeds.size()> of_{};
};

constexpr ResultTable kResults;

TypeSet aggregate_results(Operator op, TypeSet left, TypeSet right) {
  TypeSet found;
  for (const Type a : kTypes) {
    if (!left.contains(a)) continue;
    for (const Type b : kTypes) {
      if (!right.contains(b) || !(is_aggregate(a) || is_aggregate(b))) continue;
      if (const std::optional<Type> both = matrix_result(op, a, b)) found = found | *both;
    }
  }
  return found;
}

}  // namespace

std::optional<Operator> operator_of(TokenKind kind) {
  if (kind == TokenKind::Plus) return Operator::Plus;
  if (kind == TokenKind::Minus) return Operator::Minus;
  if (kind == TokenKind::Multiply) return Operator::Multiply;
  if (kind == TokenKind::Divide || kind == TokenKind::Frac) return Operator::Divide;
  if (kind == TokenKind::Cross) return Operator::Cross;
  if (kind == TokenKind::Caret) return Operator::Power;
  return std::nullopt;
}

std::span<const Type> TypeSet::all_types() {
  return kTypes;
}

Type TypeSet::only_aggregate() const {
  for (const Type type : kTypes) {
    if (*this == TypeSet(type)) return is_aggregate(type) ? type : Type::Error;
  }
  return Type::Error;
}

std::string_view operator_needs(Operator op) {
  return kNeeds[static_cast<size_t>(op)];
}

std::string_view matrix_operator_needs(Operator op) {
  return kMatrixNeeds[static_cast<size_t>(op)];
}

std::optional<Type> result(Operator op, Type left, Type right) {
  if (is_aggregate(left) || is_aggregate(right)) return matrix_result(op, left, right);
  const Type found = kResults.of(op, left, right);
  return found == kNoRule ? std::nullopt : std::optional(found);
}

TypeSet results(Operator op, TypeSet left, TypeSet right) {
  TypeSet found;
  for (const Rule& rule : kRules) {
    if (rule.op == op && left.contains(rule.left) && right.contains(rule.right)) found = found | rule.result;
  }
  if (left.contains(Type::Error) || right.contains(Type::Error)) found = found | Type::Error;
  const bool may_be_aggregate = !((left | right) & TypeSet::aggregates()).empty();
  return may_be_aggregate ? found | aggregate_results(op, left, right) : found;
}

}  // namespace texbrdf
