#include <gtest/gtest.h>

#include <array>
#include <string_view>

#include "semantics/conventions.h"
#include "semantics/operator_rules.h"
#include "semantics/types.h"

namespace texbrdf {
namespace {

TEST(Types, AreShownAsPeopleWriteThem) {
  EXPECT_EQ(type_symbol(Type::Real), "ℝ");
  EXPECT_EQ(type_symbol(Type::Vector), "ℝ³");
  EXPECT_EQ(type_symbol(Type::Colour), "RGB");
  EXPECT_EQ(type_symbol(Type::Tuple), "ℝ³/RGB");
  EXPECT_EQ(type_components(Type::Vector), 3u);
  EXPECT_EQ(signature_text({.is_function = false, .parameters = {}, .result = Type::Vector}), "ℝ³");
  EXPECT_EQ(signature_text({.is_function = true, .parameters = {Type::Real, Type::Vector}, .result = Type::Vector}),
            "ℝ × ℝ³ → ℝ³");
}

constexpr auto kValues = std::to_array<Type>({Type::Real, Type::Vector, Type::Colour, Type::Tuple});

// By the types left and right in the order of kValues, what the operator gives: R, V, C, T, or - for an error.
struct Grid {
  Operator op;
  std::string_view rows[kValues.size()];

  std::optional<Type> at(size_t left, size_t right) const {
    const size_t type = std::string_view("RVCT").find(rows[left][right]);
    return type == std::string_view::npos ? std::nullopt : std::optional(kValues[type]);
  }
};

constexpr auto kGrids = std::to_array<Grid>({
    {Operator::Plus, {"R-CC", "-V-V", "C-CC", "CVCT"}},
    {Operator::Minus, {"R-CC", "-V-V", "C-CC", "CVCT"}},
    {Operator::Multiply, {"RVCT", "VR-R", "C-CC", "TRCC"}},
    {Operator::SideBySide, {"RVCT", "V---", "C-CC", "T-CC"}},
    {Operator::Divide, {"R-CC", "V---", "C-CC", "T-CC"}},
    {Operator::Cross, {"RVCT", "VV-V", "C-CC", "TVCV"}},
    {Operator::Power, {"R-CC", "----", "C-CC", "C-CC"}},
});

TEST(OperatorRules, AreThoseOfTheLanguage) {
  for (const Grid& grid : kGrids) {
    for (size_t left = 0; left < kValues.size(); ++left) {
      for (size_t right = 0; right < kValues.size(); ++right) {
        const std::optional<Type> expected = grid.at(left, right);
        EXPECT_EQ(result(grid.op, kValues[left], kValues[right]), expected);
        EXPECT_EQ(results(grid.op, kValues[left], kValues[right]), expected ? TypeSet(*expected) : TypeSet());
      }
      EXPECT_EQ(results(grid.op, kValues[left], Type::Error), TypeSet(Type::Error));
      EXPECT_EQ(results(grid.op, Type::Error, kValues[left]), TypeSet(Type::Error));
    }
  }
}

TEST(OperatorRules, GiveTheResultThatEveryTypeOfAnUnknownOperandHas) {
  const auto common = [&](const Grid& grid, Type left, Type right) {
    TypeSet found;
    for (size_t a = 0; a < kValues.size(); ++a) {
      for (size_t b = 0; b < kValues.size(); ++b) {
        const bool is_left = left == Type::Error || left == kValues[a];
        const bool is_right = right == Type::Error || right == kValues[b];
        const std::optional<Type> type = is_left && is_right ? grid.at(a, b) : std::nullopt;
        if (type) found = found | *type;
      }
    }
    for (Type type : kValues) {
      if (found == TypeSet(type)) return type;
    }
    // What is guessed, so that one error does not become many.
    const bool beside_real = left == Type::Real || right == Type::Real;
    if (beside_real && found == (TypeSet(Type::Real) | Type::Colour)) return Type::Real;
    return grid.op == Operator::Cross && left == right ? Type::Vector : Type::Error;
  };
  for (const Grid& grid : kGrids) {
    for (Type known : {Type::Error, Type::Real, Type::Vector, Type::Colour, Type::Tuple}) {
      EXPECT_EQ(result(grid.op, known, Type::Error), common(grid, known, Type::Error));
      EXPECT_EQ(result(grid.op, Type::Error, known), common(grid, Type::Error, known));
    }
  }
}

TEST(OperatorRules, GiveAllResultsOfOpenOperands) {
  const TypeSet open = TypeSet::any_value();
  EXPECT_EQ(results(Operator::Multiply, open, open), open);
  EXPECT_EQ(results(Operator::Cross, open, open), open);
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
