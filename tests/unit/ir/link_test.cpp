#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "ir/print.h"
#include "ir/program.h"
#include "ir/validate.h"
#include "support/linkable_document.h"

namespace texbrdf::ir {
namespace {

std::string equation(const std::string& text) {
  return "\\begin{equation}\n" + text + "\n\\end{equation}\n";
}

std::vector<std::string> definition_names(const Program& program) {
  std::vector<std::string> names;
  for (const ProgramDefinition& definition : program.definitions) names.push_back(definition.canonical);
  return names;
}

const std::string kShaded = equation("f = \\rho * g(m)") + equation("g(x) = x * m") + equation("m = 0.5") +
                            equation("\\rho = \\vec{0.1, 0.2, 0.3}");

TEST(Link, TakesDefinitionsInOrderOfFirstMentionAndTheRootLast) {
  const test::LinkableDocument document(equation("unused = 2 * a") + equation("f = b + a * c") + equation("c = a + d") +
                                        equation("d = \\pi") + equation("a = \\epsilon + 0") + equation("b = 1 + d"));
  const auto program = document.link();
  ASSERT_TRUE(program);
  EXPECT_EQ(definition_names(*program), (std::vector<std::string>{"d", "b", "a", "c", "f"}));
}

TEST(Link, LinksAnyRoot) {
  const test::LinkableDocument document(kShaded);
  const auto program = document.link("g");
  ASSERT_TRUE(program);
  EXPECT_EQ(definition_names(*program), std::vector<std::string>{"g"});
  EXPECT_EQ(program->parameters.size(), 1u);
}

TEST(Link, SetsParametersByName) {
  LinkOptions options;
  options.values = {{"m", {0.25}}, {"\\rho", {0.5, 0.25, 1}}};
  const auto program = test::LinkableDocument(kShaded).link("f", options);
  ASSERT_TRUE(program) << program.error();
  for (const Parameter& p : program->parameters) EXPECT_EQ(p.value[0], p.canonical == "m" ? 0.25 : 0.5);
}

TEST(Link, WidensTheRangeToAValueFromOutside) {
  LinkOptions options;
  options.values = {{"m", {-7}}};
  const auto program = test::LinkableDocument(kShaded).link("g", options);
  ASSERT_TRUE(program);
  EXPECT_EQ(program->parameters[0].value[0], -7);
  EXPECT_EQ(program->parameters[0].minimum, -7);
  EXPECT_EQ(find_fault(*program), std::nullopt);
}

struct BadValue {
  const char* title;
  std::string name;
  std::vector<double> numbers;
  const char* message;
};

const BadValue kBadValues[] = {
    {"UnknownName", "k", {1}, "`k` is no parameter; the parameters are `\\rho` (three numbers), `m` (a number)"},
    {"NoParameter", "g", {1}, "`g` is no parameter; the parameters are `\\rho` (three numbers), `m` (a number)"},
    {"TooMany", "m", {1, 2, 3}, "`m` takes 1 number, got 3"},
    {"TooFew", "\\rho", {1}, "`\\rho` takes 3 numbers, got 1"},
    {"Infinite", "m", {INFINITY}, "`m` takes finite numbers only"},
    {"NotANumber", "\\rho", {0, std::numeric_limits<double>::quiet_NaN(), 0}, "`\\rho` takes finite numbers only"},
};

class BadValues : public testing::TestWithParam<BadValue> {};

TEST_P(BadValues, AreFailures) {
  LinkOptions options;
  options.values = {{GetParam().name, GetParam().numbers}};
  const auto program = test::LinkableDocument(kShaded).link("f", options);
  ASSERT_FALSE(program);
  EXPECT_EQ(program.error(), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(All, BadValues, testing::ValuesIn(kBadValues),
                         [](const auto& parameter) { return std::string(parameter.param.title); });

TEST(Link, SaysThatThereAreNoParameters) {
  LinkOptions options;
  options.values = {{"f", {1}}};
  const auto program = test::LinkableDocument(equation("f = 0.5")).link("f", options);
  ASSERT_FALSE(program);
  EXPECT_EQ(program.error(), "`f` is no parameter; there are no parameters");
}

/// A definition whose graph uses the given names.
LinkableDefinition using_names(uint32_t own, std::vector<uint32_t> used) {
  LinkableDefinition definition;
  definition.id = {own};
  definition.canonical = fmt::format("d_{{{}}}", own);
  definition.signature.result = Type::Real;
  ValueId sum = definition.graph.constant(1);
  for (const uint32_t name : used) {
    sum = definition.graph.add(Op::Add, {sum, definition.graph.leaf(Op::Reference, Type::Real, name)});
  }
  definition.graph.roots = {sum};
  return definition;
}

DefinitionLookup lookup_in(const std::vector<LinkableDefinition>& definitions) {
  return [&definitions](const Instance& wanted) {
    const uint32_t index = wanted.function.value;
    return index < definitions.size() ? &definitions[index] : nullptr;
  };
}

TEST(Link, FailsWhereADefinitionIsMissingOrCircular) {
  const std::vector<LinkableDefinition> definitions{using_names(0, {1}), using_names(1, {2}), using_names(2, {1}),
                                                    using_names(3, {9})};
  const auto lookup = lookup_in(definitions);
  EXPECT_EQ(link(lookup, {0}, {}).error(), "`d_{2}` is defined by itself");
  EXPECT_EQ(link(lookup, {3}, {}).error(), "`d_{3}` uses a name whose definition is missing or has errors");
  EXPECT_EQ(link(lookup, {9}, {}).error(), "the definition that is asked for is missing or has errors");
}

TEST(Link, FollowsAChainOfAnyLength) {
  constexpr uint32_t kLength = 20'000;
  std::vector<LinkableDefinition> definitions;
  for (uint32_t i = 0; i + 1 < kLength; ++i) definitions.push_back(using_names(i, {i + 1}));
  definitions.push_back(using_names(kLength - 1, {}));
  const auto program = link(lookup_in(definitions), {0}, {});
  ASSERT_TRUE(program);
  EXPECT_EQ(program->definitions.size(), kLength);
  const auto flat = flatten(*program);
  ASSERT_TRUE(flat);
  EXPECT_EQ(flat->size(), 2 * kLength - 1);
}

}  // namespace
}  // namespace texbrdf::ir
