#include "ir/graph.h"

#include <gtest/gtest.h>

#include "ir/print.h"
#include "source/internal_error.h"
#include "support/random_graph.h"
#include "support/read_graph.h"

namespace texbrdf::ir {
namespace {

TEST(Ops, StandInTheTableInTheOrderOfTheirNumbers) {
  for (uint32_t i = 0; i <= static_cast<uint32_t>(Op::Tanh); ++i) {
    EXPECT_EQ(op_entry(static_cast<Op>(i)).op, static_cast<Op>(i));
  }
}

struct TypeRule {
  const char* title;
  Op op;
  std::vector<Type> operands;
  Type result;
};

const TypeRule kTypeRules[] = {
    {"RealAndReal", Op::Add, {Type::Real, Type::Real}, Type::Real},
    {"RealIsSpread", Op::Multiply, {Type::Real, Type::Vector}, Type::Vector},
    {"RealIsSpreadBehind", Op::Divide, {Type::Colour, Type::Real}, Type::Colour},
    {"Vectors", Op::Subtract, {Type::Vector, Type::Vector}, Type::Vector},
    {"VectorWithColour", Op::Add, {Type::Colour, Type::Vector}, Type::Vector},
    {"NegativeVector", Op::Negate, {Type::Vector}, Type::Vector},
    {"BooleanIsNoNumber", Op::Add, {Type::Boolean, Type::Real}, Type::Error},
    {"DotProduct", Op::Dot, {Type::Vector, Type::Colour}, Type::Real},
    {"DotProductOfReals", Op::Dot, {Type::Real, Type::Real}, Type::Error},
    {"CrossProduct", Op::Cross, {Type::Vector, Type::Vector}, Type::Vector},
    {"PowerOfColour", Op::Power, {Type::Colour, Type::Real}, Type::Colour},
    {"ColourAsExponent", Op::Power, {Type::Real, Type::Colour}, Type::Colour},
    {"FunctionOfColour", Op::Exp, {Type::Colour}, Type::Colour},
    {"MinimumOfColourAndReal", Op::Min, {Type::Colour, Type::Real}, Type::Colour},
    {"FunctionOfBoolean", Op::Exp, {Type::Boolean}, Type::Error},
    {"AngleOfColours", Op::Arctan2, {Type::Colour, Type::Colour}, Type::Error},
    {"Comparison", Op::Less, {Type::Real, Type::Real}, Type::Boolean},
    {"ComparisonOfVectors", Op::Equal, {Type::Vector, Type::Vector}, Type::Error},
    {"Junction", Op::And, {Type::Boolean, Type::Boolean}, Type::Boolean},
    {"Selection", Op::Select, {Type::Boolean, Type::Vector, Type::Colour}, Type::Vector},
    {"SelectionOfMixedTypes", Op::Select, {Type::Boolean, Type::Real, Type::Vector}, Type::Error},
    {"SumOfVectors", Op::Sum, {Type::Real, Type::Real, Type::Vector}, Type::Vector},
    {"SumOverAVector", Op::Sum, {Type::Vector, Type::Real, Type::Real}, Type::Error},
    {"VectorOfReals", Op::MakeVector, {Type::Real, Type::Real, Type::Real}, Type::Vector},
    {"ComponentOfAReal", Op::Component, {Type::Real}, Type::Error},
    {"TooFewOperands", Op::Add, {Type::Real}, Type::Error},
    {"TypeFromElsewhere", Op::Formal, {}, Type::Error},
};

class TypeRules : public testing::TestWithParam<TypeRule> {};

TEST_P(TypeRules, Hold) {
  EXPECT_EQ(result_type(GetParam().op, GetParam().operands), GetParam().result);
}

INSTANTIATE_TEST_SUITE_P(All, TypeRules, testing::ValuesIn(kTypeRules),
                         [](const auto& parameter) { return std::string(parameter.param.title); });

TEST(Graph, RefusesOperandsThatDoNotFit) {
  Graph graph;
  const ValueId light = graph.convention(Convention::OmegaI);
  EXPECT_THROW(graph.add(Op::Arctan2, {light, light}), InternalError);
  EXPECT_THROW(graph.convention(Convention::ThetaI, std::vector{light}), InternalError);
}

TEST(Graph, KnowsWhichBindersAValueDependsOn) {
  Graph graph;
  const uint32_t outer = graph.new_binder();
  const uint32_t inner = graph.new_binder();
  const ValueId one = graph.constant(1);
  const ValueId i = graph.leaf(Op::BoundVariable, Type::Real, outer);
  const ValueId k = graph.leaf(Op::BoundVariable, Type::Real, inner);
  const ValueId product = graph.add(Op::Multiply, {i, k});
  const ValueId inner_sum = graph.add(Op::Sum, {one, i, product}, inner);
  const ValueId outer_sum = graph.add(Op::Product, {one, one, inner_sum}, outer);
  EXPECT_EQ(graph.at(one).binders, 0u);
  EXPECT_EQ(graph.at(product).binders, 0b11u);
  EXPECT_EQ(graph.at(inner_sum).binders, 0b01u);
  EXPECT_EQ(graph.at(outer_sum).binders, 0u);
  EXPECT_EQ(graph.binder_count(), 2u);
}

TEST(Graph, HasAtMostSixtyFourBinders) {
  Graph graph;
  for (uint32_t i = 0; i < kMaxBinders; ++i) EXPECT_EQ(graph.new_binder(), i);
  EXPECT_THROW(graph.new_binder(), InternalError);
}

TEST(PrintedGraph, ReadsBackToTheSameText) {
  for (uint64_t seed = 0; seed < 100; ++seed) {
    const std::string text = print_graph(test::random_graph(seed));
    EXPECT_EQ(print_graph(test::read_graph(text)), text);
  }
}

}  // namespace
}  // namespace texbrdf::ir
