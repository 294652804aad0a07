#include "eval/schedule.h"

#include <algorithm>
#include <map>
#include <set>

#include "source/internal_error.h"
#include "support/evaluation.h"
#include "support/read_graph.h"

namespace texbrdf::eval {
namespace {

using ir::Graph;
using ir::Op;
using ir::ValueId;

/// One word a step: "3" computes %3, "3?" and "3!" open its branches, "3(" and ")3" are its loop.
std::string describe(const Graph& graph) {
  std::string text;
  for (const Step& step : schedule(graph).steps) {
    const std::string id = std::to_string(step.value.value);
    switch (step.kind) {
      case Step::Kind::Compute:
        text += id + " ";
        break;
      case Step::Kind::IfTrue:
        text += id + "? ";
        break;
      case Step::Kind::IfFalse:
        text += id + "! ";
        break;
      case Step::Kind::BeginLoop:
        text += id + "( ";
        break;
      case Step::Kind::EndLoop:
        text += ")" + id + " ";
        break;
    }
  }
  return text;
}

TEST(Schedule, LeavesOutWhatNoRootNeeds) {
  EXPECT_EQ(describe(test::read_graph("%0: ℝ = constant 1\n%1: ℝ = constant 2\n%2: ℝ = negate %0\nroots %2")), "0 2 ");
}

TEST(Schedule, PutsValuesIntoTheOnlyBranchThatUsesThem) {
  EXPECT_EQ(describe(test::read_graph("%0: ℝ = parameter 0\n"
                                      "%1: 𝔹 = less %0 %0\n"
                                      "%2: ℝ = exp %0\n"
                                      "%3: ℝ = sin %0\n"
                                      "%4: ℝ = cos %3\n"
                                      "%5: ℝ = select %1 %2 %4\n"
                                      "roots %5")),
            "0 1 5? 2 5! 3 4 5 ");
}

TEST(Schedule, PutsSharedValuesBeforeBothBranches) {
  EXPECT_EQ(describe(test::read_graph("%0: ℝ = parameter 0\n"
                                      "%1: 𝔹 = less %0 %0\n"
                                      "%2: ℝ = exp %0\n"
                                      "%3: ℝ = sin %2\n"
                                      "%4: ℝ = cos %2\n"
                                      "%5: ℝ = select %1 %3 %4\n"
                                      "roots %5")),
            "0 1 2 5? 3 5! 4 5 ");
}

TEST(Schedule, HoistsWhatDoesNotDependOnTheVariable) {
  EXPECT_EQ(describe(test::read_graph("%0: ℝ = parameter 0\n"
                                      "%1: ℝ = exp %0\n"
                                      "%2: ℝ = bound 0\n"
                                      "%3: ℝ = multiply %1 %2\n"
                                      "%4: ℝ = sum 0 %0 %0 %3\n"
                                      "roots %4")),
            "0 1 4( 2 3 )4 ");
}

TEST(Schedule, HoistsOutOfTheInnerLoopOnlyWhatDependsOnTheOuter) {
  EXPECT_EQ(describe(test::read_graph("%0: ℝ = parameter 0\n"
                                      "%1: ℝ = bound 0\n"
                                      "%2: ℝ = exp %1\n"
                                      "%3: ℝ = bound 1\n"
                                      "%4: ℝ = multiply %2 %3\n"
                                      "%5: ℝ = sum 1 %0 %0 %4\n"
                                      "%6: ℝ = sum 0 %0 %0 %5\n"
                                      "roots %6")),
            "0 6( 1 2 5( 3 4 )5 )6 ");
}

TEST(Schedule, KnowsHowMuchIsEnoughForEachRoot) {
  const Graph graph = test::read_graph("%0: ℝ = constant 1\n%1: ℝ = negate %0\n%2: ℝ = exp %1\nroots %2 %0 %1");
  EXPECT_EQ(schedule(graph).root_end, (std::vector<uint32_t>{3, 1, 2}));
}

TEST(Schedule, RefusesAVariableOutsideOfItsReduction) {
  const Graph graph = test::read_graph("%0: ℝ = bound 0\n%1: ℝ = exp %0\nroots %1");
  EXPECT_THROW(static_cast<void>(schedule(graph)), InternalError);
}

TEST(Schedule, OfAChainOfAHundredThousand) {
  Graph graph;
  ValueId last = graph.leaf(Op::Parameter, Type::Real, 0);
  const ValueId one = graph.constant(1);
  for (int i = 0; i < 100'000; ++i) last = graph.add(Op::Add, {last, one});
  graph.roots = {last};
  EXPECT_EQ(ReferenceEvaluator(graph).evaluate({}, std::vector<Triple>{{0.5, 0, 0}})[0], 100'000.5);
  EXPECT_EQ(evaluate_batch(BatchEvaluator(graph), {Geometry{}}, {{0.5, 0, 0}})[0][0], 100'000.5);
}

TEST(Schedule, OfManyNestedSelects) {
  // p < 1 ? 1 : p < 2 ? 2 : …, every branch with the shared value p + k.
  Graph graph;
  constexpr int kDepth = 20'000;
  const ValueId p = graph.leaf(Op::Parameter, Type::Real, 0);
  ValueId chosen = graph.constant(-1);
  for (int k = kDepth; k > 0; --k) {
    const ValueId number = graph.constant(k);
    const ValueId condition = graph.add(Op::Less, {p, number});
    chosen = graph.add(Op::Select, {condition, graph.add(Op::Add, {p, number}), graph.add(Op::Negate, {chosen})});
  }
  graph.roots = {chosen};
  EXPECT_EQ(ReferenceEvaluator(graph).evaluate({}, std::vector<Triple>{{41.5, 0, 0}})[0], -83.5);
  EXPECT_EQ(evaluate_batch(BatchEvaluator(graph), {Geometry{}}, {{41.5, 0, 0}})[0][0], -83.5);
}

}  // namespace
}  // namespace texbrdf::eval
