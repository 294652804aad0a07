// Functions that are called with other types than they take by themselves, against values that are computed apart.

#include <cmath>

#include "model.h"

namespace texbrdf::test {
namespace {

using eval::Triple;

struct Call {
  const char* what;
  const char* document;  ///< defines f
  Triple expected;
};

void PrintTo(const Call& call, std::ostream* out) {
  *out << call.what;
}

constexpr Triple grey(double value) {
  return {value, value, value};
}

class Instances : public testing::TestWithParam<Call> {};

TEST_P(Instances, HaveTheirValues) {
  const Result<eval::CompiledModel> model = compile_text(GetParam().document);
  ASSERT_TRUE(model) << model.error();
  const eval::Geometry geometry = {.light = {0.6, 0, 0.8}, .view = {0, -0.28, 0.96}};
  for (const ir::Graph* graph : {&model->unoptimised, &model->optimised}) {
    const Triple value = eval::ReferenceEvaluator(*graph).evaluate(geometry, model->parameters);
    for (size_t i = 0; i < value.size(); ++i) EXPECT_NEAR(value[i], GetParam().expected[i], 1e-12);
  }
}

// The vectors of the geometry: |L - V| = 0.681175454637056, L·V = 0.768, L·N = 0.8.
INSTANTIATE_TEST_SUITE_P(
    Numeric, Instances,
    testing::ValuesIn(std::vector<Call>{
        {"dot product and product", R"($$ g(x, y) = x \cdot y, \quad f = g(\omega_i, \omega_o) + g(2, 3) $$)",
         grey(6.768)},
        {"interpolation",
         R"($$ \mathrm{mid}(a, b, t) = a(1 - t) + b t, \quad
              f = |\mathrm{mid}(\omega_i, \omega_o, 0.25)| + \mathrm{mid}(2, 4, 0.25) $$)",
         grey(3.4555103348473004)},
        {"distance", R"($$ d(a, b) = |a - b|, \quad f = d(\omega_i, \omega_o) + d(2, 5) $$)", grey(3.681175454637056)},
        {"distance of colours", R"($$ d(a, b) = |a - b|, \quad f = d((0.6, 0.4, 0.2), (0.3, 0.4, 0.6)) + d(2, 5) $$)",
         grey(3.5)},
        {"one calls another",
         R"($$ g(x, y) = x \cdot y, \quad \mathrm{mid}(a, b, t) = a(1 - t) + b t $$
            $$ w(x, y, t) = g(x, \mathrm{mid}(x, y, t)), \quad f = w(\omega_i, \omega_o, 0.3) + w(2, 3, 0.3) $$)",
         grey(5.5304)},
        {"a cross product of numbers", R"($$ c(a, b) = a \times b, \quad f = |c(\omega_i, \omega_o)| + c(2, 3) $$)",
         grey(std::sqrt(1 - 0.768 * 0.768) + 6)},
        {"a number and a vector", R"($$ g(x, y) = x \cdot y, \quad f = |g(g(\vec{n}, \omega_i), \omega_o)| $$)",
         grey(0.8)},
        {"arguments that are calls",
         R"($$ g(x, y) = x \cdot y, \quad f = g(g(\omega_i, \omega_o), g(\omega_i, \omega_o)) $$)",
         grey(0.768 * 0.768)},
        {"a tuple beside a vector", R"($$ g(x, y) = x \cdot y, \quad k = (0.6, 0.4, 0.2), \quad f = g(k, \vec{n}) $$)",
         grey(0.2)},
        {"colours component by component, as ever",
         R"($$ \mathrm{mid}(a, b, t) = a(1 - t) + b t, \quad \rho = (0.6, 0.4, 0.2), \quad
              f = \mathrm{mid}(\rho, 0.1, 0.25) + \mathrm{mid}(\omega_i, \omega_o, 0.5) \cdot \vec{n} $$)",
         {0.475 + 0.88, 0.325 + 0.88, 0.175 + 0.88}},
        {"in a loop",
         R"($$ \mathrm{mid}(a, b, t) = a(1 - t) + b t, \quad
              f = \sum_{k=1}^{20} \mathrm{mid}(\omega_i, \omega_o, k / 20) \cdot \vec{n} $$)",
         grey(17.68)},
        {"cases",
         R"($$ q(x, y) = \begin{cases} x \cdot y & \vec{n} \cdot \omega_i > 0.5 \\ 0 & \text{else} \end{cases} $$
            $$ f = q(\omega_i, \omega_o) + q(2, 3) $$)",
         grey(6.768)},
        {"bold letters that are colours",
         R"($$ F(\mathbf{a}, t) = (1 - t) \mathbf{a}, \quad
              f = F((0.36, 0, 0.64)^{0.5}, 0.5) + F(\omega_i, 0.5) \cdot \vec{n} $$)",
         {0.3 + 0.4, 0.4, 0.4 + 0.4}},
        {"a parameter that is not used", R"($$ u(x, t) = 2 t, \quad f = u(\vec{n}, 3) + u(1, 2) $$)", grey(10)},
        {"a derivative of vectors", R"($$ r(x, t) = \frac{d}{dt} (x t^2), \quad f = |r(\omega_i, 0.3)| + r(1, 0.2) $$)",
         grey(1.0)},
        {"parameters that are handed on", R"($$ p(x) = x, \quad q(a) = p(a), \quad f = |q(\omega_i)| + q(3) $$)",
         grey(4)},
        {"a caller that takes a number or a vector",
         R"($$ g(x, y) = x \cdot y, \quad k(a) = g(a, \vec{n}), \quad f = |k(0.5)| + k(\omega_i) $$)", grey(1.3)},
        {"a caller that makes sense with a vector only",
         R"($$ g(x, y) = x \cdot y, \quad k(a) = g(a, \vec{n}) + 1, \quad f = k(\omega_i) $$)", grey(1.8)},
        {"the convention follows a parameter",
         R"($$ g(x, y) = x \cdot y, \quad k(\omega_i, s) = s g(\omega_i, \vec{n}) + 0 \cdot \theta_i, \quad
              f = k(\omega_o, 2) $$)",
         grey(1.92)},
    }));

}  // namespace
}  // namespace texbrdf::test
