#include "semantics/operator_rules.h"

#include <array>

namespace texbrdf {
namespace {

constexpr auto kNeeds = std::to_array<std::string_view>({
#define OPERATOR(name, needs) needs,
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

constexpr size_t kTypes = 5;

struct ResultTable {
  // Boolean stands for "no rule": no operator gives it.
  std::array<std::array<std::array<Type, kTypes>, kTypes>, kNeeds.size()> of{};

  constexpr ResultTable() {
    for (auto& by_left : of) {
      for (size_t left = 0; left < kTypes; ++left) {
        for (size_t right = 0; right < kTypes; ++right) {
          const bool is_poisoned = left == size_t{0} || right == size_t{0};
          by_left[left][right] = is_poisoned ? Type::Error : Type::Boolean;
        }
      }
    }
    for (const Rule& rule : kRules) {
      of[static_cast<size_t>(rule.op)][static_cast<size_t>(rule.left)][static_cast<size_t>(rule.right)] = rule.result;
    }
  }
};

static_assert(static_cast<size_t>(Type::Error) == 0);
constexpr ResultTable kResults;

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

std::string_view operator_needs(Operator op) {
  return kNeeds[static_cast<size_t>(op)];
}

std::optional<Type> result(Operator op, Type left, Type right) {
  const Type found = kResults.of[static_cast<size_t>(op)][static_cast<size_t>(left)][static_cast<size_t>(right)];
  if (found == Type::Boolean) return std::nullopt;
  return found;
}

TypeSet results(Operator op, TypeSet left, TypeSet right) {
  TypeSet found;
  for (const Rule& rule : kRules) {
    if (rule.op == op && left.contains(rule.left) && right.contains(rule.right)) found = found | rule.result;
  }
  if (left.contains(Type::Error) || right.contains(Type::Error)) found = found | Type::Error;
  return found;
}

}  // namespace texbrdf
