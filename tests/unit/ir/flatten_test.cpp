#include <fmt/format.h>
#include <gtest/gtest.h>

#include "ir/print.h"
#include "ir/program.h"
#include "ir/validate.h"
#include "support/linkable_document.h"
#include "support/read_graph.h"

namespace texbrdf::ir {
namespace {

std::string equation(const std::string& text) {
  return "\\begin{equation}\n" + text + "\n\\end{equation}\n";
}

std::string flat_text(const std::string& document, bool all_plain = false) {
  const auto program = test::LinkableDocument(document).link();
  if (!program) return program.error();
  const auto flat = flatten(*program, all_plain);
  if (!flat) return flat.error();
  EXPECT_EQ(find_fault(*flat), std::nullopt);
  return print_graph(*flat);
}

TEST(Flatten, PutsEachPlainDefinitionOnceAndEachInstanceOfAFunction) {
  EXPECT_EQ(flat_text(equation("f = g(a) + g(a) + g(2) + a") + equation("a = \\theta_i") + equation("g(x) = \\exp x")),
            "%0: ℝ³ = convention N\n"
            "%1: ℝ³ = convention L\n"
            "%2: ℝ = convention theta_i %0 %1\n"
            "%3: ℝ = exp %2\n"
            "%4: ℝ = add %3 %3\n"
            "%5: ℝ = constant 2\n"
            "%6: ℝ = exp %5\n"
            "%7: ℝ = add %4 %6\n"
            "%8: ℝ = add %7 %2\n"
            "roots %8\n");
}

TEST(Flatten, GivesTheRootsParametersTheTwoDirections) {
  EXPECT_EQ(flat_text(equation("f(\\omega_o, \\vec{b}) = \\theta_o * (\\vec{b} \\cdot \\vec{n})")),
            "%0: ℝ³ = convention L\n"
            "%1: ℝ³ = convention V\n"
            "%2: ℝ³ = convention N\n"
            "%3: ℝ = convention theta_o %2 %0\n"
            "%4: ℝ = dot %1 %2\n"
            "%5: ℝ = multiply %3 %4\n"
            "roots %5\n");
}

TEST(Flatten, GivesTheValueOfEachPlainDefinition) {
  EXPECT_EQ(flat_text(equation("f = a * g(a)") + equation("a = \\pi + 1") + equation("g(x) = -x"), true),
            "%0: ℝ = convention pi\n"
            "%1: ℝ = constant 1\n"
            "%2: ℝ = add %0 %1\n"
            "%3: ℝ = negate %2\n"
            "%4: ℝ = multiply %2 %3\n"
            "roots %4 %2 %4\n");
}

TEST(Flatten, RefusesARootThatIsNoFunctionOfTwoVectors) {
  EXPECT_EQ(flat_text(equation("f(x) = x")), "`f` is no function of two vectors");
}

TEST(Flatten, StopsSoonWhereCallsDoubleAtEachLevel) {
  std::string document = equation("f = f_{40}(0.5)") + equation("f_0(x) = x");
  for (int i = 1; i <= 40; ++i)
    document += equation(fmt::format("f_{{{0}}}(x) = f_{{{1}}}(x + 1) + f_{{{1}}}(x - 1)", i, i - 1));
  const std::string answer = flat_text(document);
  EXPECT_TRUE(answer.starts_with("more than 1000000 values when every call is written out; `f_")) << answer;
}

TEST(Flatten, WritesEqualCallsOnceHoweverDeepTheyNest) {
  std::string document = equation("f = f_{40}(0.5)") + equation("f_0(x) = x");
  for (int i = 1; i <= 40; ++i)
    document += equation(fmt::format("f_{{{0}}}(x) = f_{{{1}}}(x) + f_{{{1}}}(x)", i, i - 1));
  const auto program = test::LinkableDocument(document).link();
  EXPECT_EQ(flatten(*program)->size(), 41u);
}

ProgramDefinition function_of_real(uint32_t index, const std::string& graph) {
  ProgramDefinition definition;
  definition.canonical = fmt::format("g_{{{}}}", index);
  definition.signature = {true, {Type::Real}, Type::Real};
  definition.formals.resize(1);
  definition.graph = test::read_graph(graph);
  return definition;
}

ProgramDefinition plain_root(const std::string& graph) {
  ProgramDefinition definition;
  definition.canonical = "f";
  definition.signature = {false, {}, Type::Real};
  definition.graph = test::read_graph(graph);
  return definition;
}

TEST(Flatten, FollowsCallsNestedToAnyDepth) {
  Program program;
  constexpr uint32_t kDepth = 20'000;
  program.definitions.push_back(function_of_real(0, "%0: ℝ = formal 0\n%1: ℝ = exp %0\nroots %1"));
  for (uint32_t i = 1; i < kDepth; ++i) {
    const std::string call = fmt::format("%0: ℝ = formal 0\n%1: ℝ = call @{} %0\n%2: ℝ = negate %1\nroots %2", i - 1);
    program.definitions.push_back(function_of_real(i, call));
  }
  program.definitions.push_back(
      plain_root(fmt::format("%0: ℝ = constant 1\n%1: ℝ = call @{} %0\nroots %1", kDepth - 1)));
  const auto flat = flatten(program);
  ASSERT_TRUE(flat);
  EXPECT_EQ(flat->size(), kDepth + 1);
}

const char* const kSumOfPowers =
    "%x: ℝ = formal 0\n%1: ℝ = constant 1\n%3: ℝ = constant 3\n%k: ℝ = bound k0\n%p: ℝ = power %x %k\n"
    "%s: ℝ = sum k0 %1 %3 %p\nroots %s";

TEST(Flatten, GivesEachInstanceItsOwnBinders) {
  Program program;
  program.definitions.push_back(function_of_real(0, kSumOfPowers));
  program.definitions.push_back(plain_root("%a: ℝ = constant 2\n%b: ℝ = call @0 %a\n%c: ℝ = call @0 %b\nroots %c"));
  const auto flat = flatten(program);
  ASSERT_TRUE(flat);
  EXPECT_EQ(find_fault(*flat), std::nullopt);
  EXPECT_EQ(print_graph(*flat),
            "%0: ℝ = constant 2\n"
            "%1: ℝ = constant 1\n"
            "%2: ℝ = constant 3\n"
            "%3: ℝ = bound k0\n"
            "%4: ℝ = power %0 %3\n"
            "%5: ℝ = sum k0 %1 %2 %4\n"
            "%6: ℝ = constant 1\n"
            "%7: ℝ = constant 3\n"
            "%8: ℝ = bound k1\n"
            "%9: ℝ = power %5 %8\n"
            "%10: ℝ = sum k1 %6 %7 %9\n"
            "roots %10\n");
}

TEST(Flatten, PutsACallWithinASumUnderItsBinder) {
  Program program;
  program.definitions.push_back(function_of_real(0, kSumOfPowers));
  program.definitions.push_back(
      plain_root("%1: ℝ = constant 1\n%2: ℝ = constant 2\n%k: ℝ = bound k0\n%c: ℝ = call @0 %k\n"
                 "%d: ℝ = call @0 %k\n%p: ℝ = multiply %c %d\n%s: ℝ = product k0 %1 %2 %p\nroots %s"));
  const auto flat = flatten(program);
  ASSERT_TRUE(flat);
  EXPECT_EQ(find_fault(*flat), std::nullopt);
  EXPECT_EQ(flat->binder_count(), 2u);
  EXPECT_EQ(flat->size(), 10u);
}

TEST(Flatten, FailsWhereThereAreMoreSumsThanBinders) {
  Program program;
  program.definitions.push_back(function_of_real(0, kSumOfPowers));
  std::string root = "%a0: ℝ = constant 2\n";
  for (int i = 0; i < 65; ++i) root += fmt::format("%a{}: ℝ = call @0 %a{}\n", i + 1, i);
  program.definitions.push_back(plain_root(root + "roots %a65"));
  const auto flat = flatten(program);
  ASSERT_FALSE(flat);
  EXPECT_EQ(flat.error(), "more than 64 sums and products when every call is written out");
}

}  // namespace
}  // namespace texbrdf::ir
