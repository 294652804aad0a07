// Each pass alone against the graph as it was: on random graphs, and where numbers are awkward.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "eval/evaluate.h"
#include "ir/passes/passes.h"
#include "support/linkable_document.h"
#include "support/random_document.h"
#include "support/random_graph.h"
#include "support/read_graph.h"

namespace texbrdf::test {
namespace {

using eval::Geometry;
using eval::ReferenceEvaluator;
using eval::Triple;

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::map<std::string, ir::Graph (*)(const ir::Graph&)> all_passes() {
  std::map<std::string, ir::Graph (*)(const ir::Graph&)> passes;
  for (const ir::Pass& pass : ir::evaluation_passes()) passes.emplace(pass.name, pass.run);
  for (const ir::Pass& pass : ir::emission_passes()) passes.emplace(pass.name, pass.run);
  return passes;
}

/// NaN, infinities and their signs are equal, the rest up to rounding.
void expect_same(const Triple& actual, const Triple& expected, double tolerance) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::isnan(expected[i]) || std::isinf(expected[i])) {
      EXPECT_TRUE(actual[i] == expected[i] || (std::isnan(actual[i]) && std::isnan(expected[i])))
          << actual[i] << " instead of " << expected[i];
    } else {
      EXPECT_NEAR(actual[i], expected[i], tolerance * (1 + std::abs(expected[i])));
    }
  }
}

Triple unit(const Triple& v) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

Geometry random_geometry(Random& random) {
  const auto direction = [&random] { return unit({random.real(-1, 1), random.real(-1, 1), random.real(0.1, 1)}); };
  return {.light = direction(), .view = direction()};
}

class EachPass : public testing::TestWithParam<std::string> {
 protected:
  void expect_same_values(const ir::Graph& graph, const std::vector<Triple>& parameters, uint64_t seed) {
    const ReferenceEvaluator before(graph), after(all_passes().at(GetParam())(graph));
    Random random(seed);
    for (int i = 0; i < 20; ++i) {
      const Geometry geometry = random_geometry(random);
      expect_same(after.evaluate(geometry, parameters), before.evaluate(geometry, parameters), 1e-10);
    }
    if (HasFailure()) FAIL() << "seed " << seed;
  }
};

TEST_P(EachPass, KeepsTheValuesOfRandomGraphs) {
  const std::vector<Triple> parameters{{0.3, 0.3, 0.3}, {0.2, 0.9, 0.5}};
  for (uint64_t seed = 0; seed < 200 && !HasFailure(); ++seed) {
    expect_same_values(random_graph(seed), parameters, seed);
  }
}

TEST_P(EachPass, KeepsTheValuesOfRandomDocuments) {
  for (uint64_t seed = 0; seed < 60 && !HasFailure(); ++seed) {
    const auto program = LinkableDocument(random_document(seed)).link();
    ASSERT_TRUE(program) << program.error();
    std::vector<Triple> parameters;
    for (const ir::Parameter& p : program->parameters) {
      parameters.push_back(p.type == Type::Real ? Triple{p.value[0], p.value[0], p.value[0]} : p.value);
    }
    expect_same_values(*ir::flatten(*program), parameters, seed);
  }
}

std::vector<std::string> pass_names() {
  std::vector<std::string> names;
  for (const auto& [name, pass] : all_passes()) names.push_back(name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, EachPass, testing::ValuesIn(pass_names()),
                         [](const auto& parameter) { return parameter.param; });

const double kAwkwardNumbers[] = {0.0,  -0.0,  1,     -1,    2,         -2,         0.5,   -0.5, 3,
                                  1e-9, -7.25, 1e-30, -1e30, kInfinite, -kInfinite, kNone, 1e100};

/// A graph of one real parameter, at each awkward number.
void expect_same_at_awkward_numbers(const std::string& text, ir::Graph (*pass)(const ir::Graph&)) {
  SCOPED_TRACE(text);
  const ir::Graph graph = read_graph("%x: ℝ = parameter 0\n" + text);
  const ReferenceEvaluator before(graph), after(pass(graph));
  for (const double x : kAwkwardNumbers) {
    SCOPED_TRACE(x);
    const std::vector<Triple> parameters{{x, x, x}};
    expect_same(after.evaluate({}, parameters), before.evaluate({}, parameters), 1e-13);
  }
}

TEST(ExpandPowers, KeepsZeroInfinityAndNan) {
  for (int exponent = -9; exponent <= 9; ++exponent) {
    expect_same_at_awkward_numbers("%n: ℝ = constant " + std::to_string(exponent) + "\n%r: ℝ = power %x %n\nroots %r",
                                   ir::expand_powers);
  }
  for (const char* exponent : {"0.5", "-0.5", "1.5", "-1.5"}) {
    const std::string constant = std::string("%n: ℝ = constant ") + exponent + "\n";
    expect_same_at_awkward_numbers(constant + "%r: ℝ = power %x %n\nroots %r", ir::expand_powers);
    expect_same_at_awkward_numbers(constant + "%q: ℝ = multiply %x %x\n%r: ℝ = power %q %n\nroots %r",
                                   ir::expand_powers);
    expect_same_at_awkward_numbers(constant + "%1: ℝ = constant 1\n%q: ℝ = add %x %1\n%r: ℝ = power %q %n\nroots %r",
                                   ir::expand_powers);
  }
  expect_same_at_awkward_numbers("%n: ℝ = constant 2\n%r: ℝ = root %x %n\nroots %r", ir::expand_powers);
}

TEST(FoldConstants, KeepsZeroInfinityAndNan) {
  for (const char* op : {"add", "subtract", "multiply", "divide", "min", "max", "power"}) {
    for (const char* number : {"0", "-0", "1", "-1"}) {
      const std::string constant = std::string("%c: ℝ = constant ") + number + "\n%1: ℝ = constant 1\n";
      for (const char* operands : {"%x %c", "%c %x", "%x %x"}) {
        // The reciprocal tells zeros apart.
        expect_same_at_awkward_numbers(constant + "%a: ℝ = " + op + " " + operands + "\n%r: ℝ = divide %1 %a\nroots %r",
                                       ir::fold_constants);
      }
    }
  }
}

struct AwkwardAngle {
  const char* title;
  const char* equation;
  Geometry geometry;
  double value;
};

constexpr double kHalf = 0.70710678118654752440;

const AwkwardAngle kAwkwardAngles[] = {
    {"CosineOfNoAzimuth", "\\cos{\\phi_i}", {.light = {0, 0, 1}, .view = {0, 0, 1}}, 1},
    {"SineOfNoAzimuth", "\\sin{\\phi_i}", {.light = {0, 0, 1}, .view = {0, 0, 1}}, 0},
    {"TangentOfNoAzimuth", "\\tan{\\phi_i}", {.light = {0, 0, 1}, .view = {0, 0, 1}}, 0},
    {"AzimuthOfNegativeZeros", "\\cos{\\phi_i}", {.light = {-0.0, -0.0, 1}, .view = {0, 0, 1}}, 1},
    {"AzimuthOfPi", "\\cos{\\phi_i}", {.light = {-1, 0, 0}, .view = {0, 0, 1}}, -1},
    {"DifferenceWithNoAzimuth", "\\cos{\\phi_i - \\phi_o}", {.light = {0, 0, 1}, .view = {0, kHalf, kHalf}}, 0},
    {"DifferenceAcrossPi", "\\cos{\\phi_i - \\phi_o}", {.light = {-0.6, 0.8, 0}, .view = {-0.6, -0.8, 0}}, -0.28},
    {"TwiceAnAzimuth", "\\cos{2*\\phi_i}", {.light = {0.6, 0.8, 0}, .view = {0, 0, 1}}, -0.28},
    {"CosineBeyondOne", "\\cos{\\theta_i}", {.light = {0, 0, 1.0000001}, .view = {0, 0, 1}}, 1},
    {"SineBeyondOne", "\\sin{\\theta_i}", {.light = {0, 0, 1.0000001}, .view = {0, 0, 1}}, 0},
    {"CosineBelowTheHorizon", "\\cos{\\theta_i}", {.light = {0.6, 0, -0.8}, .view = {0, 0, 1}}, -0.8},
    {"SineBelowTheHorizon", "\\sin{\\theta_i}", {.light = {0.6, 0, -0.8}, .view = {0, 0, 1}}, 0.6},
    {"OppositeDirections", "\\cos{\\theta_h}", {.light = {0, 0, 1}, .view = {0, 0, -1}}, kNone},
    {"NanInADirection", "\\cos{\\phi_i}", {.light = {kNone, 0, 1}, .view = {0, 0, 1}}, kNone},
};

class AwkwardAngles : public testing::TestWithParam<AwkwardAngle> {};

TEST_P(AwkwardAngles, HaveOneValueBeforeAndAfterThePasses) {
  const std::string text = std::string("\\begin{equation} f = ") + GetParam().equation + " \\end{equation}";
  const ir::Graph graph = *ir::flatten(*LinkableDocument(text).link());
  const Triple expected{GetParam().value, GetParam().value, GetParam().value};
  expect_same(ReferenceEvaluator(graph).evaluate(GetParam().geometry, {}), expected, 1e-15);
  const ReferenceEvaluator after(ir::run_passes(graph, ir::evaluation_passes()));
  expect_same(after.evaluate(GetParam().geometry, {}), expected, 1e-15);
}

INSTANTIATE_TEST_SUITE_P(All, AwkwardAngles, testing::ValuesIn(kAwkwardAngles),
                         [](const auto& parameter) { return std::string(parameter.param.title); });

TEST(AnglesToDotProducts, MakesTheTangentOfARightAngleInfinite) {
  const ir::Graph graph =
      *ir::flatten(*LinkableDocument("\\begin{equation} f = \\tan\\theta_i \\end{equation}").link());
  const Geometry grazing{.light = {1, 0, 0}, .view = {0, 0, 1}};
  EXPECT_GT(ReferenceEvaluator(graph).evaluate(grazing, {})[0], 1e16);
  EXPECT_EQ(ReferenceEvaluator(ir::angles_to_dot_products(graph)).evaluate(grazing, {})[0], kInfinite);
}

}  // namespace
}  // namespace texbrdf::test
