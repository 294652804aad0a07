#include <gtest/gtest.h>

#include <array>
#include <string_view>

#include "semantics/conventions.h"
#include "semantics/matrix_rules.h"
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

struct MatrixRule {
  Operator op;
  Type left, right;
  std::optional<Type> expected;
};

constexpr MatrixRule kMatrixRules[] = {
    {Operator::Plus, Type::Vector2, Type::Vector2, Type::Vector2},
    {Operator::Plus, Type::Vector2, Type::Real, std::nullopt},
    {Operator::Minus, Type::Matrix3x3, Type::Matrix3x3, Type::Matrix3x3},
    {Operator::Minus, Type::Matrix3x3, Type::Matrix3x2, std::nullopt},
    {Operator::SideBySide, Type::Real, Type::Matrix2x3, Type::Matrix2x3},
    {Operator::SideBySide, Type::Matrix2x3, Type::Vector, Type::Vector2},
    {Operator::SideBySide, Type::Matrix2x3, Type::Vector2, std::nullopt},
    {Operator::SideBySide, Type::Matrix3x3, Type::Vector, Type::Vector},
    {Operator::SideBySide, Type::Matrix3x3, Type::Colour, Type::Colour},
    {Operator::SideBySide, Type::Matrix3x3, Type::Tuple, Type::Tuple},
    {Operator::SideBySide, Type::Matrix3x2, Type::Vector2, Type::Tuple},
    {Operator::SideBySide, Type::Matrix2x3, Type::Matrix3x4, Type::Matrix2x4},
    {Operator::SideBySide, Type::Row2, Type::Vector2, Type::Real},
    {Operator::SideBySide, Type::Vector2, Type::Row3, Type::Matrix2x3},
    {Operator::SideBySide, Type::Vector2, Type::Matrix2x2, Type::Row2},
    {Operator::SideBySide, Type::Vector2, Type::Vector2, std::nullopt},
    {Operator::Multiply, Type::Vector2, Type::Vector2, Type::Real},
    {Operator::Multiply, Type::Vector4, Type::Row4, Type::Real},
    {Operator::Multiply, Type::Vector4, Type::Vector2, std::nullopt},
    {Operator::Multiply, Type::Colour, Type::Row3, std::nullopt},
    {Operator::Divide, Type::Matrix4x4, Type::Real, Type::Matrix4x4},
    {Operator::Divide, Type::Real, Type::Matrix4x4, std::nullopt},
    {Operator::Divide, Type::Vector2, Type::Vector2, std::nullopt},
    {Operator::Cross, Type::Real, Type::Matrix2x2, Type::Matrix2x2},
    {Operator::Cross, Type::Vector2, Type::Vector2, std::nullopt},
    {Operator::Power, Type::Matrix2x2, Type::Real, std::nullopt},
    {Operator::Plus, Type::Matrix2x2, Type::Error, Type::Matrix2x2},
    {Operator::Plus, Type::Error, Type::Matrix2x2, Type::Matrix2x2},
    {Operator::Divide, Type::Vector2, Type::Error, Type::Vector2},
    {Operator::Divide, Type::Error, Type::Vector2, Type::Error},
    {Operator::Multiply, Type::Matrix2x2, Type::Error, Type::Error},
};

TEST(OperatorRules, AreThoseOfLinearAlgebraBesideAggregates) {
  for (const MatrixRule& rule : kMatrixRules) {
    const std::string what = signature_text({.is_function = true, .parameters = {rule.left, rule.right}});
    EXPECT_EQ(result(rule.op, rule.left, rule.right), rule.expected) << what << static_cast<int>(rule.op);
    const TypeSet unknown = rule.left == Type::Error || rule.right == Type::Error ? TypeSet(Type::Error) : TypeSet();
    EXPECT_EQ(results(rule.op, rule.left, rule.right), rule.expected ? unknown | *rule.expected : unknown) << what;
  }
}

TEST(Types, HaveShapes) {
  EXPECT_EQ(type_symbol(Type::Matrix2x3), "ℝ²ˣ³");
  EXPECT_EQ(type_components(Type::Matrix2x3), 6u);
  EXPECT_EQ(type_of_shape({1, 1}), Type::Real);
  EXPECT_EQ(type_of_shape({3, 1}), Type::Tuple);
  EXPECT_EQ(type_of_shape({5, 1}), std::nullopt);
  EXPECT_EQ(tuple_type(2), Type::Vector2);
  EXPECT_EQ(tuple_type(3), Type::Tuple);
  EXPECT_EQ(tuple_type(1), std::nullopt);
  EXPECT_EQ(transposed(Type::Vector), Type::Row3);
  EXPECT_EQ(transposed(Type::Matrix4x2), Type::Matrix2x4);
  EXPECT_EQ(transposed(Type::Colour), std::nullopt);
  EXPECT_FALSE(is_square_matrix(Type::Matrix2x3));
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
