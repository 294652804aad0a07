#include <gtest/gtest.h>

#include "semantics/conventions.h"
#include "semantics/operator_rules.h"
#include "semantics/types.h"

namespace texbrdf {
namespace {

TEST(Types, AreShownAsPeopleWriteThem) {
  EXPECT_EQ(type_symbol(Type::Real), "ℝ");
  EXPECT_EQ(type_symbol(Type::Vector), "ℝ³");
  EXPECT_EQ(type_symbol(Type::Colour), "ℝ³");
  EXPECT_EQ(type_components(Type::Vector), 3u);
  EXPECT_EQ(signature_text({.is_function = false, .parameters = {}, .result = Type::Vector}), "ℝ³");
  EXPECT_EQ(signature_text({.is_function = true, .parameters = {Type::Real, Type::Vector}, .result = Type::Vector}),
            "ℝ × ℝ³ → ℝ³");
}

// All that is legal; every other pair of real and vector is an error.
TEST(OperatorRules, AreThoseOfTheLanguage) {
  struct Legal {
    Operator op;
    Type left, right, result;
  };
  using enum Type;
  using enum Operator;
  const Legal legal[] = {
      {Plus, Real, Real, Real},         {Plus, Vector, Vector, Vector},   {Minus, Real, Real, Real},
      {Minus, Vector, Vector, Vector},  {Multiply, Real, Real, Real},     {Multiply, Real, Vector, Vector},
      {Multiply, Vector, Real, Vector}, {Multiply, Vector, Vector, Real}, {Divide, Real, Real, Real},
      {Divide, Vector, Real, Vector},   {Cross, Vector, Vector, Vector},  {Power, Real, Real, Real}};
  for (Operator op : {Plus, Minus, Multiply, Divide, Cross, Power}) {
    for (Type left : {Real, Vector}) {
      for (Type right : {Real, Vector}) {
        std::optional<Type> expected;
        for (const Legal& rule : legal) {
          if (rule.op == op && rule.left == left && rule.right == right) expected = rule.result;
        }
        EXPECT_EQ(result(op, left, right), expected);
        EXPECT_EQ(results(op, left, right).empty(), !expected.has_value());
      }
      EXPECT_EQ(results(op, left, Type::Error), TypeSet(Type::Error));
      EXPECT_EQ(results(op, Type::Error, left), TypeSet(Type::Error));
    }
  }
}

TEST(OperatorRules, GiveTheResultThatEveryTypeOfAnUnknownOperandHas) {
  const Type operands[] = {Type::Real, Type::Vector};
  const auto common = [&](Operator op, Type left, Type right) {
    TypeSet found;
    for (Type a : operands) {
      for (Type b : operands) {
        const bool is_reading = (left == Type::Error || left == a) && (right == Type::Error || right == b);
        const std::optional<Type> type = is_reading ? result(op, a, b) : std::nullopt;
        if (type) found = found | *type;
      }
    }
    for (Type type : operands) {
      if (found == TypeSet(type)) return type;
    }
    return Type::Error;
  };
  for (Operator op :
       {Operator::Plus, Operator::Minus, Operator::Multiply, Operator::Divide, Operator::Cross, Operator::Power}) {
    for (Type known : {Type::Error, Type::Real, Type::Vector}) {
      EXPECT_EQ(result(op, known, Type::Error), common(op, known, Type::Error));
      EXPECT_EQ(result(op, Type::Error, known), common(op, Type::Error, known));
    }
  }
}

TEST(OperatorRules, GiveAllResultsOfOpenOperands) {
  const TypeSet open = TypeSet::any_value();
  EXPECT_EQ(results(Operator::Multiply, open, open), open);
  EXPECT_EQ(results(Operator::Cross, open, open), TypeSet(Type::Vector));
  EXPECT_EQ(results(Operator::Divide, open, Type::Vector), TypeSet());
}

TEST(Conventions, HaveTheirSpellingsAndOperands) {
  EXPECT_EQ(find_convention("\\vec{\\omega_i}"), Convention::OmegaI);
  EXPECT_EQ(find_convention("\\omega_i"), Convention::OmegaI);
  EXPECT_EQ(find_convention("\\theta_h"), Convention::ThetaH);
  EXPECT_EQ(find_convention("n"), std::nullopt);
  EXPECT_EQ(convention_entry(Convention::ThetaH).operands, (std::vector{Convention::Normal, Convention::Half}));
  EXPECT_EQ(convention_entry(Convention::PhiI).operands.size(), 3u);
  EXPECT_EQ(convention_constant(Convention::Pi), 3.141592653589793);
  EXPECT_EQ(convention_constant(Convention::Epsilon), 1.192092896e-07);
  EXPECT_EQ(convention_constant(Convention::ThetaI), std::nullopt);
  for (const ConventionEntry& entry : conventions()) {
    EXPECT_EQ(convention_entry(entry.id).symbol, entry.symbol);
    for (Convention operand : entry.operands) EXPECT_LT(operand, entry.id) << "operands come first";
  }
}

}  // namespace
}  // namespace texbrdf
