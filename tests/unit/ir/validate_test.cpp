#include "ir/validate.h"

#include <gtest/gtest.h>

#include "source/internal_error.h"
#include "support/random_graph.h"
#include "support/read_graph.h"

namespace texbrdf::ir {
namespace {

struct BrokenGraph {
  const char* title;
  const char* text;
  const char* fault;
};

const BrokenGraph kBrokenGraphs[] = {
    {"Empty", "", "no root"},
    {"NoRoot", "%0: ℝ = constant 1\nroots", "no root"},
    {"RootThatDoesNotExist", "%0: ℝ = constant 1\nroots %7", "a root that does not exist"},
    {"OperandAfterUser", "%0: ℝ = sin %1\n%1: ℝ = constant 1\nroots %0",
     "%0: an operand that does not come before its user"},
    {"OperandOfItself", "%0: ℝ = sin %0\nroots %0", "%0: an operand that does not come before its user"},
    {"TooFewOperands", "%0: ℝ = constant 1\n%1: ℝ = add %0\nroots %1", "%1: add with 1 operands"},
    {"TooManyOperands", "%0: ℝ = constant 1\n%1: ℝ = sin %0 %0\nroots %1", "%1: sin with 2 operands"},
    {"OperandsThatDoNotFit", "%0: ℝ³ = convention L\n%1: ℝ = arctan2 %0 %0\nroots %1",
     "%1: arctan2 of operands that do not fit"},
    {"VectorAndRealInDot", "%0: ℝ³ = convention L\n%1: ℝ = constant 1\n%2: ℝ = dot %0 %1\nroots %2",
     "%2: dot of operands that do not fit"},
    {"ConditionThatIsReal", "%0: ℝ = constant 1\n%1: ℝ = select %0 %0 %0\nroots %1",
     "%1: select of operands that do not fit"},
    {"BranchesOfDifferentTypes",
     "%0: ℝ = constant 1\n%1: ℝ³ = convention L\n%2: 𝔹 = less %0 %0\n%3: ℝ = select %2 %0 %1\nroots %3",
     "%3: select of operands that do not fit"},
    {"TypeThatDoesNotFollow", "%0: ℝ = constant 1\n%1: ℝ³ = sin %0\nroots %1",
     "%1: a type that does not follow from its operands"},
    {"ConstantThatIsAVector", "%0: ℝ³ = constant 1\nroots %0", "%0: a type that does not follow from its operands"},
    {"ParameterWithoutType", "%0: ? = parameter 0\nroots %0", "%0: a value without a type"},
    {"ComponentBeyondTheThird", "%0: ℝ³ = convention L\n%1: ℝ = component 3 %0\nroots %1",
     "%1: a component beyond the third"},
    {"ConventionThatDoesNotExist", "%0: ℝ = convention 99\nroots %0", "%0: a convention that does not exist"},
    {"ConventionOfAnotherType", "%0: ℝ = convention L\nroots %0", "%0: a convention of another type"},
    {"ConventionWithoutOperands", "%0: ℝ = convention theta_i\nroots %0",
     "%0: a convention with another number of operands"},
    {"ConventionOfWrongOperands", "%0: ℝ = constant 1\n%1: ℝ = convention theta_i %0 %0\nroots %1",
     "%1: a convention with an operand of another type"},
    {"BoundVariableThatIsNotReal", "%0: ℝ³ = bound k0\n%1: ℝ = constant 1\n%2: ℝ³ = sum k0 %1 %1 %0\nroots %2",
     "%0: a bound variable that is not real"},
    {"BinderOfTwoReductions",
     "%0: ℝ = bound k0\n%1: ℝ = constant 1\n%2: ℝ = sum k0 %1 %1 %0\n%3: ℝ = product k0 %1 %1 %0\n"
     "%4: ℝ = add %2 %3\nroots %4",
     "%3: a binder of two reductions"},
    {"RangeThatDependsOnItsBinder", "%0: ℝ = bound k0\n%1: ℝ = constant 1\n%2: ℝ = sum k0 %1 %0 %0\nroots %2",
     "%2: a range that depends on its own binder"},
    {"UnboundVariable", "%0: ℝ = bound k0\nroots %0", "a root with an unbound variable"},
};

class BrokenGraphs : public testing::TestWithParam<BrokenGraph> {};

TEST_P(BrokenGraphs, AreRejected) {
  const Graph graph = test::read_graph(GetParam().text);
  EXPECT_EQ(find_fault(graph), GetParam().fault);
  EXPECT_THROW(validate(graph, "a test"), InternalError);
}

INSTANTIATE_TEST_SUITE_P(All, BrokenGraphs, testing::ValuesIn(kBrokenGraphs),
                         [](const auto& parameter) { return std::string(parameter.param.title); });

TEST(Validate, RejectsPayloadsThatAnOpDoesNotHave) {
  Graph index;
  index.roots = {index.copy({.op = Op::Constant, .type = Type::Real, .index = 3}, {})};
  EXPECT_EQ(find_fault(index), "%0: an index that its op does not have");
  Graph number;
  number.roots = {number.copy({.op = Op::Parameter, .type = Type::Real, .constant = 3}, {})};
  EXPECT_EQ(find_fault(number), "%0: a constant that its op does not have");
}

TEST(Validate, TakesVectorAndColourForOneType) {
  Graph graph;
  const ValueId colour = graph.leaf(Op::Parameter, Type::Colour, 0);
  const ValueId light = graph.convention(Convention::OmegaI);
  graph.roots = {graph.add(Op::Add, {colour, light}), graph.add(Op::Dot, {light, colour})};
  EXPECT_EQ(find_fault(graph), std::nullopt);
}

TEST(Validate, AcceptsRandomGraphs) {
  for (uint64_t seed = 0; seed < 200; ++seed) {
    EXPECT_EQ(find_fault(test::random_graph(seed)), std::nullopt) << seed;
  }
}

/// A function of one real, and a root that calls it and uses one parameter.
Program small_program() {
  Program program;
  program.parameters.resize(1);
  program.parameters[0].canonical = "m";
  ProgramDefinition square;
  square.canonical = "s";
  square.signature = {true, {Type::Real}, Type::Real};
  square.formals.resize(1);
  const ValueId x = square.graph.leaf(Op::Formal, Type::Real, 0);
  square.graph.roots = {square.graph.add(Op::Multiply, {x, x})};
  ProgramDefinition root;
  root.canonical = "f";
  root.signature = {false, {}, Type::Real};
  const ValueId m = root.graph.leaf(Op::Parameter, Type::Real, 0);
  root.graph.roots = {root.graph.leaf(Op::Call, Type::Real, 0, std::vector{m})};
  program.definitions = {square, root};
  return program;
}

struct BrokenProgram {
  const char* title;
  void (*damage)(Program&);
  const char* fault;
};

/// The root's graph with its two values replaced.
void set_root_graph(Program& program, const char* text) {
  program.definitions.back().graph = test::read_graph(text);
}

const BrokenProgram kBrokenPrograms[] = {
    {"NoDefinition", [](Program& p) { p.definitions.clear(); }, "a program without a root"},
    {"ParameterOfAnotherType", [](Program& p) { p.parameters[0].type = Type::Boolean; },
     "m: a parameter of another type"},
    {"EmptyRange", [](Program& p) { p.parameters[0].minimum = 2; }, "m: an empty range"},
    {"BrokenGraph", [](Program& p) { set_root_graph(p, "%0: ℝ = sin %0\nroots %0"); },
     "f: %0: an operand that does not come before its user"},
    {"SeveralRoots", [](Program& p) { set_root_graph(p, "%0: ℝ = constant 1\nroots %0 %0"); },
     "f: a definition with several roots"},
    {"RootOfAnotherType", [](Program& p) { set_root_graph(p, "%0: ℝ³ = convention L\nroots %0"); },
     "f: a root of another type"},
    {"FormalsThatDoNotFit", [](Program& p) { p.definitions[0].formals.clear(); }, "s: formals that do not fit"},
    {"NoSuchFormal", [](Program& p) { set_root_graph(p, "%0: ℝ = formal 0\nroots %0"); }, "f: %0: no such formal"},
    {"NoSuchParameter", [](Program& p) { set_root_graph(p, "%0: ℝ = parameter 1\nroots %0"); },
     "f: %0: no such parameter"},
    {"UseOfALaterDefinition", [](Program& p) { set_root_graph(p, "%0: ℝ = reference @1\nroots %0"); },
     "f: %0: a definition that does not come before its user"},
    {"FunctionAsAValue", [](Program& p) { set_root_graph(p, "%0: ℝ = reference @0\nroots %0"); },
     "f: %0: a call of what is no function, or a function as a value"},
    {"CallOfAnotherType",
     [](Program& p) { set_root_graph(p, "%0: ℝ³ = convention L\n%1: ℝ³ = call @0 %0\n%2: ℝ = dot %1 %0\nroots %2"); },
     "f: %1: a definition of another type"},
    {"WrongNumberOfArguments", [](Program& p) { set_root_graph(p, "%0: ℝ = call @0\nroots %0"); },
     "f: %0: a wrong number of arguments"},
    {"ArgumentOfAnotherType",
     [](Program& p) { set_root_graph(p, "%0: ℝ³ = convention L\n%1: ℝ = call @0 %0\nroots %1"); },
     "f: %1: an argument of another type"},
};

class BrokenPrograms : public testing::TestWithParam<BrokenProgram> {};

TEST_P(BrokenPrograms, AreRejected) {
  Program program = small_program();
  ASSERT_EQ(find_fault(program), std::nullopt);
  GetParam().damage(program);
  EXPECT_EQ(find_fault(program), GetParam().fault);
}

INSTANTIATE_TEST_SUITE_P(All, BrokenPrograms, testing::ValuesIn(kBrokenPrograms),
                         [](const auto& parameter) { return std::string(parameter.param.title); });

}  // namespace
}  // namespace texbrdf::ir
