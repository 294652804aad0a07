#include "eval/limits.h"
#include "support/evaluation.h"
#include "support/read_graph.h"

namespace texbrdf::eval {
namespace {

constexpr Geometry kAnyGeometry{.light = {0, 0, 1}, .view = {0, 0, 1}};

/// 1 + … + 1, five times; then the sine of that.
const char* const kLoop =
    "%0: ℝ = constant 1\n"
    "%1: ℝ = constant 5\n"
    "%k: ℝ = bound k0\n"
    "%b: ℝ = multiply %k %0\n"
    "%s: ℝ = sum k0 %0 %1 %b\n"
    "%r: ℝ = add %s %1\n"
    "roots %s %r";

uint64_t steps_of(const ReferenceEvaluator& evaluator, std::size_t root) {
  StepBudget budget{1000};
  EXPECT_TRUE(evaluator.evaluate(kAnyGeometry, {}, root, budget));
  return 1000 - budget.left;
}

TEST(StepBudget, CountsEachIteration) {
  const ReferenceEvaluator evaluator(test::read_graph(kLoop));
  const uint64_t sum = steps_of(evaluator, 0);
  EXPECT_GE(sum, 5U * 2);
  EXPECT_GT(steps_of(evaluator, 1), sum);
}

TEST(StepBudget, EndsTheEvaluationOneStepTooEarly) {
  const ReferenceEvaluator evaluator(test::read_graph(kLoop));
  const uint64_t needed = steps_of(evaluator, 0);
  StepBudget enough{needed};
  EXPECT_EQ(evaluator.evaluate(kAnyGeometry, {}, 0, enough), (Triple{15, 15, 15}));
  EXPECT_EQ(enough.left, 0U);
  StepBudget too_little{needed - 1};
  EXPECT_EQ(evaluator.evaluate(kAnyGeometry, {}, 0, too_little), std::nullopt);
}

TEST(StepBudget, IsSharedByAllRoots) {
  const ReferenceEvaluator evaluator(test::read_graph(kLoop));
  StepBudget budget{steps_of(evaluator, 1)};
  EXPECT_EQ(evaluator.evaluate_all(kAnyGeometry, {}, budget), (std::vector<Triple>{{15, 15, 15}, {20, 20, 20}}));
  EXPECT_EQ(budget.left, 0U);
  StepBudget too_little{steps_of(evaluator, 0)};
  EXPECT_EQ(evaluator.evaluate_all(kAnyGeometry, {}, too_little), std::nullopt);
}

}  // namespace
}  // namespace texbrdf::eval
