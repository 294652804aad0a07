// Each op, in a graph made by hand, as the target `glsl` writes it.

#include <gtest/gtest.h>

#include <string>

#include "emit/emit.h"
#include "support/read_graph.h"

namespace texbrdf::emit {
namespace {

/// The body of the entry point behind its first line, without comments and helpers.
std::string body_of(const std::string& graph_text) {
  ir::Program program;
  program.parameters.resize(2);
  program.parameters[0].name.base = "p";
  program.parameters[0].value = {0.5, 0, 0};
  program.parameters[1].name.base = "q";
  program.parameters[1].type = Type::Colour;
  ir::ProgramDefinition& root = program.definitions.emplace_back();
  root.name.base = "f";
  root.graph = test::GraphReader(graph_text).read();
  root.signature.result = root.graph.at(root.graph.roots[0]).type;
  Result<EmittedCode> code = find_target("glsl")->emit(program, {.parameters = ParameterStyle::Uniform});
  if (!code) return code.error();
  std::size_t body = code->text.find("vec3 brdf(");
  body = code->text.find('\n', body) + 1;
  return code->text.substr(body, code->text.rfind('}') - body);
}

struct OpCase {
  std::string name;
  std::string graph;
  std::string body;
};

class OpText : public testing::TestWithParam<OpCase> {};

TEST_P(OpText, IsAsExpected) {
  EXPECT_EQ(body_of(GetParam().graph), GetParam().body);
}

const std::string kLeaves =
    "%l: ℝ³ = convention L\n%v: ℝ³ = convention V\n%n: ℝ³ = convention N\n%p: ℝ = parameter 0\n"
    "%q: ℝ³ = parameter 1\n%1: ℝ = constant 1\n%2: ℝ = constant 2\n%x: ℝ = dot %l %q\n";

OpCase real(std::string name, const std::string& op, const std::string& expression) {
  return {std::move(name), kLeaves + "%r: ℝ = " + op + "\nroots %r\n", "  return vec3(" + expression + ");\n"};
}

OpCase triple(std::string name, const std::string& op, const std::string& expression) {
  return {std::move(name), kLeaves + "%r: ℝ³ = " + op + "\nroots %r\n", "  return " + expression + ";\n"};
}

OpCase select(std::string name, const std::string& condition, const std::string& expression) {
  return {std::move(name),
          kLeaves + "%c: 𝔹 = less %p %1\n%d: 𝔹 = " + condition + "\n%r: ℝ = select %d %p %x\nroots %r\n",
          "  return vec3(" + expression + " ? p : dot(L, q));\n"};
}

INSTANTIATE_TEST_SUITE_P(
    Emit, OpText,
    testing::Values(
        real("constant", "constant 0.25", "0.25"), real("large", "constant 1e300", "1.0 / 0.0"),
        real("negative", "constant -2", "-2.0"), real("parameter", "parameter 0", "p"),
        triple("colour", "parameter 1", "q"), triple("input", "convention X", "X"),
        triple("half", "convention H %l %v", "normalize(L + V)"),
        triple("vector", "vector %p %1 %2", "vec3(p, 1.0, 2.0)"), real("component", "component 2 %q", "q.z"),
        real("negate", "negate %p", "-p"), real("add", "add %p %x", "p + dot(L, q)"),
        triple("subtract", "subtract %q %l", "q - L"), triple("multiply", "multiply %p %q", "p * q"),
        triple("divide", "divide %q %p", "q / p"), real("min", "min %p %x", "min(p, dot(L, q))"),
        real("max", "max %p %1", "max(p, 1.0)"), triple("cross", "cross %l %q", "cross(L, q)"),
        real("exp", "exp %p", "exp(p)"), triple("exp_of_colour", "exp %q", "exp(q)"),
        triple("below_a_colour", "divide %p %q", "p / q"), triple("real_less_colour", "subtract %p %q", "p - q"),
        triple("square_of_colour", "power %q %2", "q * q"),
        triple("power_of_colour", "power %q %p", "power(q, vec3(p))"),
        triple("colour_as_exponent", "power %p %q", "power(vec3(p), q)"),
        triple("root_of_colour", "root %q %p", "root(q, vec3(p))"), triple("min_of_colour", "min %p %q", "min(q, p)"),
        triple("max_of_colour", "max %q %p", "max(q, p)"), triple("arccos_of_colour", "arccos %q", "arccos(q)"),
        real("ln", "ln %p", "log(p)"), real("sqrt", "sqrt %p", "sqrt(p)"), real("sin", "sin %p", "sin(p)"),
        real("cos", "cos %p", "cos(p)"), real("tan", "tan %p", "tan(p)"), real("arcsin", "arcsin %p", "arcsin(p)"),
        real("arccos", "arccos %p", "arccos(p)"), real("arctan", "arctan %p", "atan(p)"),
        real("arctan2", "arctan2 %p %x", "atan(p, dot(L, q))"), real("sinh", "sinh %p", "sinh(p)"),
        real("cosh", "cosh %p", "cosh(p)"), real("tanh", "tanh %p", "tanh(p)"), real("square", "power %p %2", "p * p"),
        real("square_of_more", "power %x %2", "square(dot(L, q))"), real("power", "power %p %x", "power(p, dot(L, q))"),
        real("root", "root %p %x", "root(p, dot(L, q))"), real("square_root", "root %p %2", "sqrt(p)"),
        select("less", "less %p %1", "p < 1.0"), select("less_equal", "less_equal %p %1", "p <= 1.0"),
        select("equal", "equal %p %1", "p == 1.0"), select("not", "not %c", "!(p < 1.0)")),
    [](const auto& param) { return param.param.name; });

TEST(OpText, AndOr) {
  EXPECT_EQ(body_of(kLeaves + "%c: 𝔹 = less %p %1\n%d: 𝔹 = less %x %2\n%a: 𝔹 = and %c %d\n%o: 𝔹 = or %a %c\n"
                              "%r: ℝ = select %o %p %x\nroots %r\n"),
            "  return vec3((p < 1.0 && dot(L, q) < 2.0) || p < 1.0 ? p : dot(L, q));\n");
}

TEST(OpText, DivisionByAWrittenZeroIsInfinite) {
  EXPECT_EQ(body_of(kLeaves + "%0: ℝ = constant 0\n%r: ℝ = divide %p %0\nroots %r\n"),
            "  return vec3(p * (1.0 / 0.0));\n");
  EXPECT_EQ(body_of(kLeaves + "%0: ℝ = constant 0\n%r: ℝ = divide %1 %0\nroots %r\n"), "  return vec3(1.0 / 0.0);\n");
}

TEST(OpText, ArccosineOfUnitVectorsNeedsNoHelper) {
  EXPECT_EQ(body_of(kLeaves + "%d: ℝ = dot %l %n\n%r: ℝ = arccos %d\nroots %r\n"),
            "  return vec3(acos(clamp(dot(L, N), -1.0, 1.0)));\n");
}

TEST(OpText, ExtremaKeepNanThatARegionOfInputsGives) {
  EXPECT_EQ(body_of(kLeaves + "%s: ℝ = sqrt %x\n%r: ℝ = max %s %1\nroots %r\n"),
            "  return vec3(maximum(sqrt(dot(L, q)), 1.0));\n");
}

TEST(OpText, ExtremaOfNumbersInOrderAreAClamp) {
  EXPECT_EQ(body_of(kLeaves + "%s: ℝ = min %x %2\n%r: ℝ = max %1 %s\nroots %r\n"),
            "  return vec3(clamp(dot(L, q), 1.0, 2.0));\n");
  EXPECT_EQ(body_of(kLeaves + "%s: ℝ = min %x %1\n%r: ℝ = max %2 %s\nroots %r\n"),
            "  return vec3(max(2.0, min(dot(L, q), 1.0)));\n");
}

TEST(OpText, SumIsALoop) {
  EXPECT_EQ(body_of("%1: ℝ = constant 1\n%5: ℝ = constant 5\n%k: ℝ = bound 0\n%s: ℝ = multiply %k %k\n"
                    "%r: ℝ = sum 0 %1 %5 %s\nroots %r\n"),
            "  float sum = 0.0;\n"
            "  for (int k = 1; k <= 5; ++k) {\n"
            "    sum += float(k) * float(k);\n"
            "  }\n"
            "  return vec3(sum);\n");
}

TEST(OpText, ReductionsNestAndTakeTriples) {
  EXPECT_EQ(body_of("%1: ℝ = constant 1\n%2: ℝ = constant 2\n%n: ℝ³ = convention N\n%j: ℝ = bound 0\n%k: ℝ = bound 1\n"
                    "%s: ℝ = add %j %k\n%p: ℝ = product 1 %1 %2 %s\n%v: ℝ³ = multiply %p %n\n"
                    "%r: ℝ³ = sum 0 %1 %2 %v\nroots %r\n"),
            "  vec3 sum = vec3(0.0);\n"
            "  for (int k = 1; k <= 2; ++k) {\n"
            "    float product = 1.0;\n"
            "    for (int k_2 = 1; k_2 <= 2; ++k_2) {\n"
            "      product *= float(k) + float(k_2);\n"
            "    }\n"
            "    sum += product * N;\n"
            "  }\n"
            "  return sum;\n");
}

TEST(OpText, BoundsKnownAtRunTimeAreLimited) {
  EXPECT_EQ(body_of("%1: ℝ = constant 1\n%p: ℝ = parameter 0\n%k: ℝ = bound 0\n%r: ℝ = sum 0 %1 %p %k\nroots %r\n"),
            "  float sum = p - 1.0 < 65535.0 ? 0.0 : 0.0 / 0.0;\n"
            "  for (int k_step = 0; k_step < 65535 && float(k_step) <= p - 1.0; ++k_step) {\n"
            "    float k = 1.0 + float(k_step);\n"
            "    sum += k;\n"
            "  }\n"
            "  return vec3(sum);\n");
}

}  // namespace
}  // namespace texbrdf::emit
