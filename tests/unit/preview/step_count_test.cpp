#include "preview/step_count.h"

#include <gtest/gtest.h>

#include "eval/limits.h"
#include "support/read_graph.h"

namespace texbrdf::preview {
namespace {

double steps(const std::string& graph, const std::vector<eval::Triple>& parameters = {}) {
  return most_steps(test::read_graph(graph), parameters);
}

TEST(MostSteps, CountsValues) {
  EXPECT_EQ(steps("%0: ℝ = constant 1\n%1: ℝ = sin %0\nroots %1"), 2);
}

TEST(MostSteps, CountsTheBodyOfALoopForEachIteration) {
  // Two bounds; ten times the variable, its product and the addition.
  EXPECT_EQ(steps("%0: ℝ = constant 1\n%1: ℝ = constant 10\n%k: ℝ = bound k0\n%b: ℝ = multiply %k %0\n"
                  "%s: ℝ = sum k0 %0 %1 %b\nroots %s"),
            2 + 10 * 3);
}

TEST(MostSteps, LoopsWithinLoopsMultiply) {
  EXPECT_EQ(steps("%0: ℝ = constant 1\n%1: ℝ = constant 10\n%j: ℝ = bound k1\n%k: ℝ = bound k0\n"
                  "%b: ℝ = multiply %k %j\n%s: ℝ = sum k0 %0 %1 %b\n%t: ℝ = product k1 %0 %1 %s\nroots %t"),
            2 + 10 * (1 + 1) + 10 + 100 + 100);
}

TEST(MostSteps, BoundsMayBeParameters) {
  const std::string graph =
      "%0: ℝ = constant 1\n%1: ℝ = parameter 0\n%k: ℝ = bound k0\n%s: ℝ = sum k0 %0 %1 %k\nroots %s";
  EXPECT_EQ(steps(graph, {{7, 7, 7}}), 2 + 7 * 2);
  EXPECT_EQ(steps(graph, {{-7, -7, -7}}), 2 + 2);
  EXPECT_EQ(steps(graph, {{1e6, 1e6, 1e6}}), 2 + 2);
}

TEST(MostSteps, OtherBoundsCountAsTheLargest) {
  EXPECT_EQ(steps("%0: ℝ = constant 1\n%1: ℝ = sin %0\n%k: ℝ = bound k0\n%s: ℝ = sum k0 %0 %1 %k\nroots %s"),
            2 + 2.0 * eval::kMaxIterations);
}

}  // namespace
}  // namespace texbrdf::preview
