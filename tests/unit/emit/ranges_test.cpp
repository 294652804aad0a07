#include "emit/ranges.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "support/read_graph.h"

namespace texbrdf::emit {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const std::string kLeaves =
    "%l: ℝ³ = convention L\n%n: ℝ³ = convention N\n%p: ℝ = parameter 0\n%2: ℝ = constant 2\n"
    "%x: ℝ = dot %l %n\n";

Range range_of(const std::string& values) {
  ir::Graph graph = test::read_graph(kLeaves + values);
  return find_ranges(graph, {}, {}).back();
}

void expect_range(const std::string& values, double least, double most, bool can_fail) {
  Range range = range_of(values);
  EXPECT_EQ(range.least, least) << values;
  EXPECT_EQ(range.most, most) << values;
  EXPECT_EQ(range.can_fail, can_fail) << values;
}

TEST(Ranges, OfDirections) {
  expect_range("", -1, 1, false);
  expect_range("%c: ℝ³ = cross %l %n\n%r: ℝ = dot %c %n", -1, 1, false);
  expect_range("%s: ℝ³ = add %l %n\n%r: ℝ = dot %s %s", 0, 4, false);
  expect_range("%r: ℝ = component 1 %l", -1, 1, false);
}

TEST(Ranges, OfArithmetic) {
  expect_range("%r: ℝ = add %x %2", 1, 3, false);
  expect_range("%r: ℝ = subtract %x %2", -3, -1, false);
  expect_range("%r: ℝ = multiply %x %x", 0, 1, false);
  expect_range("%r: ℝ = multiply %x %2", -2, 2, false);
  expect_range("%r: ℝ = divide %2 %x", -kInfinity, kInfinity, false);
  expect_range("%s: ℝ = add %x %2\n%r: ℝ = divide %2 %s", 2.0 / 3, 2, false);
  expect_range("%r: ℝ = negate %2", -2, -2, false);
  expect_range("%r: ℝ = min %x %p", -kInfinity, 1, false);
  expect_range("%r: ℝ = max %x %p", -1, kInfinity, false);
}

TEST(Ranges, KnowWhatFailsForARegionOfInputs) {
  expect_range("%r: ℝ = sqrt %x", 0, 1, true);
  expect_range("%s: ℝ = multiply %x %x\n%r: ℝ = sqrt %s", 0, 1, false);
  expect_range("%r: ℝ = ln %p", -kInfinity, kInfinity, true);
  expect_range("%r: ℝ = arccos %x", 0, kPi, false);
  expect_range("%r: ℝ = arccos %p", 0, kPi, true);
  expect_range("%r: ℝ = power %p %x", -kInfinity, kInfinity, true);
  expect_range("%r: ℝ = power %p %2", 0, kInfinity, false);
  expect_range("%s: ℝ = exp %p\n%r: ℝ = power %s %p", 0, kInfinity, false);
}

TEST(Ranges, ReachThroughFunctions) {
  ir::Program program;
  auto define = [&](const std::string& values, std::size_t formals) {
    ir::ProgramDefinition& definition = program.definitions.emplace_back();
    definition.formals.resize(formals);
    definition.signature.is_function = formals > 0;
    definition.graph = test::read_graph(values);
    definition.graph.roots = {ir::ValueId{definition.graph.size() - 1}};
  };
  define("%x: ℝ = formal 0\n%y: ℝ = formal 1\n%r: ℝ = tanh %x", 2);
  define(kLeaves + "%s: ℝ = sqrt %x\n%r: ℝ = call 0 %x %s", 0);
  define("%d: ℝ = reference 1", 0);
  ProgramRanges ranges = find_ranges(program);
  EXPECT_EQ(ranges.definitions[0].most, 1);
  EXPECT_FALSE(ranges.formals_can_fail[0][0]);
  EXPECT_TRUE(ranges.formals_can_fail[0][1]);
  EXPECT_EQ(ranges.definitions[2].least, -1);
}

}  // namespace
}  // namespace texbrdf::emit
