// Sums, products, integrals and derivatives against closed forms and finite differences, with and without passes, in
// double and in single precision.

#include <cmath>

#include "closed_form.h"

namespace texbrdf::test {
namespace {

using eval::Triple;

class CalculusTest : public testing::TestWithParam<ClosedForm> {};

TEST_P(CalculusTest, HasItsValue) {
  expect_closed_form(GetParam());
}

constexpr double kPiHere = 3.141592653589793;

const ClosedForm kSums[] = {
    {"up_to_a_plus", R"($$ f = \sum_{k=1}^{3} k + 10 $$)", 16},
    {"all_of_a_product", R"($$ f = \sum_{k=1}^{3} 2 k \cdot k / 2 - 1 $$)", 13},
    {"indexed", R"($$ a_1 = 0.1, \quad a_2 = 0.2, \quad f = \sum_{k=1}^2 k a_k $$)", 0.5},
    {"indexed_in_a_list", R"($$ a_{x,1} = 2, \quad a_{x,2} = 3, \quad f = \prod_{l=1}^2 a_{x,l} $$)", 6},
    {"indexed_functions", R"($$ g_1(x) = x, \quad g_2(x) = x^2, \quad f = \sum_{i=1}^{2} g_i(3) $$)", 12},
    {"as_many_as_a_parameter_says",
     R"($$ N = 2, \quad a_1 = 1, \quad a_2 = 2, \quad a_3 = 4, \quad f = \sum_{k=1}^{N} a_k $$)", 3},
    {"more_than_there_are_names_for", R"($$ a_1 = 1, \quad a_2 = 2, \quad N = 1, \quad f = \sum_{k=1}^{N+1} a_k $$)",
     3},
    {"a_set", R"($$ f = \sum_{k \in \{1, 2, 5\}} k^2 $$)", 30},
    {"a_loop", R"($$ f = \sum_{k=0}^{40} 2^{-k} $$)", 2, 1e-10},
    {"a_loop_as_long_as_a_parameter", R"($$ N = 10, \quad f = \prod_{k=1}^{N} \frac{k}{k+1} $$)", 1.0 / 11},
    {"a_loop_of_colours", R"($$ c = (1, 2, 3), \quad f = \sum_{k=1}^{20} c\,k $$)", 210},
    {"nested", R"($$ f = \sum_{i=1}^{4} \sum_{j=1}^{i} i j $$)", 65},
    {"hides_names", R"($$ k = 100, \quad f = \sum_{k=1}^{2} k $$)", 3},
    {"an_index_beside_a_direction", R"($$ f = \sum_{i=1}^{2} i (n \cdot \omega_i) $$)", 2.4},
    {"none", R"($$ f = 1 + \sum_{k=2}^{1} k $$)", 1},
    {"no_limits", R"($$ f = \sum\nolimits_{k=1}^2 k + \sum\limits_{l=1}^2 l^2 $$)", 8},
    {"an_exponent_of_a_function", R"($$ f = \sum_{i=0}^{2} \sin^i\theta_i $$)", 1.96},
};

const ClosedForm kIntegrals[] = {
    {"of_a_sum", R"($$ f = \int_0^1 3 x^2 + 1\,dx $$)", 2},
    {"upright", R"($$ f = \int_0^\pi \sin t\,\mathrm{d}t $$)", 2},
    {"over_a_fraction", R"($$ f = \int_0^1 \frac{dx}{1 + x^2} + 1 $$)", kPiHere / 4 + 1},
    {"in_front", R"($$ f = \int_0^1 dx\,x^2 $$)", 1.0 / 3},
    {"with_limits", R"($$ f = \int\limits_0^{\pi/2} \cos\theta \sin\theta\; d\theta $$)", 0.5},
    {"nested", R"($$ f = \int_0^1 \int_0^x x y\,dy\,dx $$)", 0.125},
    {"bounds_that_depend", R"($$ g(a) = \int_0^a e^{-t}\,dt, \quad f = g(\cos\theta_i) $$)", 1 - std::exp(-0.8)},
    {"over_the_hemisphere", R"($$ f = \int_\Omega (n \cdot \omega)\,d\omega $$)", kPiHere},
    {"of_its_angle", R"($$ f = \int_{\mathcal{H}^2} \cos^3\theta_i\,\mathrm d\omega_i $$)", kPiHere / 2},
    {"over_the_sphere", R"($$ f = \int_{S^2} (n \cdot \omega)^2\,d\omega $$)", 4 * kPiHere / 3},
    {"of_a_colour", R"($$ c = (1, 2, 3), \quad f = \int_0^2 c\,x\,dx $$)", 2},
    {"of_a_peak", R"($$ f = \int_0^{\pi/2} \frac{\sin x}{(\cos^2 x\,(0.01 - 1) + 1)^2}\,dx $$)", 51.490, 1e-3},
};

const ClosedForm kDerivatives[] = {
    {"operator", R"($$ g(x) = \frac{d}{dx} x^3, \quad f = g(2) $$)", 12},
    {"quotient", R"($$ h(x) = \sin x, \quad g(x) = \frac{d h(x)}{dx}, \quad f = g(1) $$)", std::cos(1.0)},
    {"prime", R"($$ g(x) = x^2 e^x, \quad f = g'(1) $$)", 3 * std::exp(1.0)},
    {"by_a_parameter", R"($$ a = 0.5, \quad b = a^2, \quad D = b + 3 a, \quad f = \frac{\partial D}{\partial a} $$)",
     4},
    {"of_a_sum", R"($$ g(x) = \frac{d}{dx} \sum_{k=1}^{20} x^k, \quad f = g(0.5) $$)", 3.99995803833008, 1e-10},
    {"of_a_product", R"($$ g(x) = \frac{d}{dx} \prod_{k=1}^{20} (1 + k x), \quad f = g(0) $$)", 210},
    {"of_an_integral", R"($$ g(x) = \frac{d}{dx} \int_0^x t^2 \, dt, \quad f = g(2) $$)", 4},
    {"under_an_integral", R"($$ g(x) = \frac{d}{dx} \int_0^1 \sin(x t)\,dt, \quad f = g(2) $$)",
     std::sin(2.0) / 2 + (std::cos(2.0) - 1) / 4},
    {"in_an_integral", R"($$ g(x) = x^3, \quad f = \int_0^2 g'(x)\,dx $$)", 8},
    {"twice", R"($$ g(x) = \frac{d}{dx} \frac{d}{dx} x^4, \quad f = g(1) $$)", 12},
    {"second", R"($$ g(x) = \frac{d^2}{dx^2} x^4 y, \quad y = 3, \quad f = g(1) $$)", 36},
    {"second_of_a_quotient", R"($$ g(x) = \frac{d^{2} \sin x}{d x^{2}}, \quad f = g(1) $$)", -std::sin(1.0)},
    {"third_upright", R"($$ g(t) = \frac{\mathrm{d}^3}{\mathrm{d}t^3} t^4, \quad f = g(2) $$)", 48},
    {"mixed", R"($$ g(x, y) = \frac{\partial^3 (x^3 y^2)}{\partial x^2 \partial y}, \quad f = g(2, 3) $$)", 72},
    {"mixed_operator", R"($$ g(x, y) = \frac{\partial^2}{\partial x \partial y} x^3 y^2, \quad f = g(2, 3) $$)", 72},
    {"mixed_by_parameters",
     R"($$ x = 2, \quad y = 3, \quad D = x^3 y^2, \quad f = \frac{\partial^2 D}{\partial x \partial y} $$)", 72},
    {"in_a_function_by_a_parameter", R"($$ t = 2, \quad c(x) = \frac{\partial}{\partial t} x t^2, \quad f = c(3) $$)",
     12},
    {"mixed_by_an_argument_and_a_parameter",
     R"($$ t = 2, \quad c(x) = \frac{\partial^2 (x^3 t^2)}{\partial x \partial t}, \quad f = c(3) $$)", 108},
    {"second_by_a_parameter", R"($$ a = 2, \quad D = a^4, \quad f = \frac{\partial^2 D}{\partial a^2} + a $$)", 50},
    {"second_by_an_angle", R"($$ f = \frac{d^2}{d\theta_h^2} \theta_h^2 $$)", 2},
    {"two_primes", R"($$ g(x) = x^2 e^x, \quad f = g''(1) $$)", 7 * std::exp(1.0)},
    {"three_primes", R"($$ g(x) = x^4, \quad f = g^{\prime\prime\prime}(2) + g'''(1) $$)", 72},
    {"of_a_vector_function", R"($$ g(x) = |\vec{n} x + \vec{1, 0, 0}|, \quad f = g'(1) $$)", std::sqrt(0.5)},
    {"of_an_extremum", R"($$ g(x) = \max(x^2, 3 x), \quad f = g'(1) + g'(4) $$)", 11},
};

INSTANTIATE_TEST_SUITE_P(Sums, CalculusTest, testing::ValuesIn(kSums), closed_form_name);
INSTANTIATE_TEST_SUITE_P(Integrals, CalculusTest, testing::ValuesIn(kIntegrals), closed_form_name);
INSTANTIATE_TEST_SUITE_P(Derivatives, CalculusTest, testing::ValuesIn(kDerivatives), closed_form_name);

struct Slope {
  const char* name;
  const char* function;  ///< of x
  double at;
};

class SlopeTest : public testing::TestWithParam<Slope> {};

TEST_P(SlopeTest, IsThatOfFiniteDifferences) {
  const Slope& example = GetParam();
  const std::string function = "$$ g(x) = " + std::string(example.function) + " $$\n";
  const auto value = [&](const std::string& f) {
    const Result<eval::CompiledModel> model = compile_text(function + "$$ f = " + f + " $$");
    EXPECT_TRUE(model) << model.error();
    return model ? eval::ReferenceEvaluator(model->unoptimised).evaluate(some_geometry(), model->parameters)[0] : 0;
  };
  constexpr double kStep = 1e-5;
  const auto at = [](double x) { return "(" + std::to_string(x) + ")"; };
  const double by_difference =
      (value("g" + at(example.at + kStep)) - value("g" + at(example.at - kStep))) / (2 * kStep);
  EXPECT_NEAR(value("g'" + at(example.at)), by_difference, 1e-6 * std::max(1.0, std::abs(by_difference)));
}

const Slope kSlopes[] = {
    {"quotient", "\\frac{1 + x}{2 + x^2}", 0.7},
    {"power_of_itself", "x^x", 1.3},
    {"roots", "\\sqrt{x} + \\sqrt[3]{x}", 0.9},
    {"logarithm", "\\ln(1 + x^2)", 0.4},
    {"trigonometry", "\\sin(x) \\cos(2 x) + \\tan(x / 2)", 0.8},
    {"inverse_trigonometry", "\\arcsin(x) - \\arccos(x / 2) + \\arctan(3 x)", 0.3},
    {"hyperbolic", "\\sinh(x) + \\cosh(x) \\tanh(x)", 0.6},
    {"absolute", "|x - 2|", 0.5},
    {"positive_part", "\\langle x - 0.2 \\rangle^2", 0.6},
};

std::string slope_name(const testing::TestParamInfo<Slope>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(All, SlopeTest, testing::ValuesIn(kSlopes), slope_name);

TEST(Sums, HaveNoValueForMoreTermsThanThereAreNamesFor) {
  const Result<eval::CompiledModel> model =
      compile_text(R"($$ N = 3, \quad a_1 = 1, \quad a_2 = 2, \quad f = \sum_{k=1}^{N} a_k $$)");
  ASSERT_TRUE(model) << model.error();
  EXPECT_TRUE(std::isnan(eval::ReferenceEvaluator(model->unoptimised).evaluate({}, model->parameters)[0]));
}

}  // namespace
}  // namespace texbrdf::test
