// Cases, conditions and what else is decided by a comparison: values that are computed here.

#include <cmath>
#include <functional>

#include "model.h"

namespace texbrdf::test {
namespace {

using eval::Triple;

/// Of the cosines of the light's and the viewer's angle.
using Value = std::function<double(double l, double v)>;

struct Decision {
  const char* what;
  std::vector<std::string> equations;  // the last one is the BRDF
  Value red;
  Value green = red;
};

void PrintTo(const Decision& decision, std::ostream* out) {
  *out << decision.what;
}

class Decisions : public testing::TestWithParam<Decision> {
 protected:
  void SetUp() override {
    std::string text =
        "\\begin{equation}l = \\omega_i \\cdot \\vec{n}\\end{equation}\n"
        "\\begin{equation}v = \\omega_o \\cdot \\vec{n}\\end{equation}\n";
    for (const std::string& equation : GetParam().equations) text += "\\[" + equation + "\\]\n";
    Result<eval::CompiledModel> model = compile_text(text);
    ASSERT_TRUE(model) << model.error();
    model_ = *std::move(model);
    for (const ReferenceRow& row : read_reference("conventions")) geometries_.push_back(row.geometry);
    ASSERT_FALSE(geometries_.empty());
  }

  void expect(const std::vector<Triple>& values, double relative, const std::string& what) const {
    Deviation deviation(relative, 1e-6);
    for (size_t i = 0; i < values.size(); ++i) {
      const double l = geometries_[i].light[2];
      const double v = geometries_[i].view[2];
      const Triple expected = {GetParam().red(l, v), GetParam().green(l, v), values[i][2]};
      deviation.compare(values[i], expected, what + ", row " + std::to_string(i + 1));
    }
    EXPECT_LE(deviation.share(), 1) << deviation.first_failure();
  }

  std::vector<Triple> in_double(const ir::Graph& graph) const {
    const eval::ReferenceEvaluator evaluator(graph);
    std::vector<Triple> values;
    for (const eval::Geometry& geometry : geometries_)
      values.push_back(evaluator.evaluate(geometry, model_.parameters));
    return values;
  }

  eval::CompiledModel model_;
  std::vector<eval::Geometry> geometries_;
};

TEST_P(Decisions, AreTakenInDouble) {
  expect(in_double(model_.unoptimised), 1e-9, "no passes");
  expect(in_double(model_.optimised), 1e-9, "all passes");
}

TEST_P(Decisions, AreTakenInBatches) {
  for (const eval::Backend& backend : eval::backends()) {
    const eval::BatchEvaluator evaluator(model_.optimised, backend.set, *backend.functions);
    expect(evaluate_batch(evaluator, geometries_, model_.parameters), 1e-3, backend.name);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, Decisions,
    testing::ValuesIn(std::vector<Decision>{
        {"two rows",
         {"f = \\begin{cases} 2l & l > v \\\\ 3v & \\text{otherwise} \\end{cases}"},
         [](double l, double v) { return l > v ? 2 * l : 3 * v; }},
        {"the first row that applies",
         {"f = \\begin{cases} 1 & l < 0.9 \\\\ 2 & l < 0.95 \\\\ 3 & l \\ge 0.95 \\end{cases}"},
         [](double l, double) { return l < 0.9 ? 1 : (l < 0.95 ? 2 : 3); }},
        {"the rest in front",
         {"f = \\begin{cases} 7 & \\text{otherwise} \\\\ 2 & l > v \\end{cases}"},
         [](double l, double v) { return l > v ? 2 : 7; }},
        {"no row applies", {"f = \\begin{cases} 1 & l > 2 \\end{cases}"}, [](double, double) { return 0; }},
        {"what is not taken is not seen",
         {"g(x) = \\begin{cases} \\sqrt{x} & x > 0 \\\\ \\ln(1 - x) & x \\le 0 \\end{cases}",
          "f = g(l - v) + \\begin{cases} \\frac{0}{l - l} & l > 2 \\\\ 1 & \\text{else} \\end{cases}"},
         [](double l, double v) { return (l > v ? std::sqrt(l - v) : std::log(1 - l + v)) + 1; }},
        {"nor what both rows share",
         {"q = \\sqrt{l - v}", "f = \\begin{cases} q + q^2 & l > v \\\\ 1 & l \\le v \\end{cases}"},
         [](double l, double v) { return l > v ? std::sqrt(l - v) + l - v : 1; }},
        {"a chain",
         {"f = \\begin{cases} 1 & 0.5 < l \\le v \\\\ 2 & \\text{else} \\end{cases}"},
         [](double l, double v) { return 0.5 < l && l <= v ? 1 : 2; }},
        {"both and one",
         {"f = \\begin{cases} 1 & l > 0.5 \\land v > 0.5 \\\\ 2 & l > 0.9 \\text{ or } v > 0.9 \\\\ 3 \\end{cases}"},
         [](double l, double v) { return l > 0.5 && v > 0.5 ? 1 : (l > 0.9 || v > 0.9 ? 2 : 3); }},
        {"not",
         {"f = \\begin{cases} 1 & \\neg(l > v) \\\\ 2 & l \\ne v \\end{cases}"},
         [](double l, double v) { return l > v ? 2 : 1; }},
        {"an interval",
         {"f = \\begin{cases} 1 & l \\in (0.3, 0.7] \\\\ 2 & v \\in [0.5, 1] \\\\ 3 & \\text{else} \\end{cases}"},
         [](double l, double v) { return 0.3 < l && l <= 0.7 ? 1 : (0.5 <= v && v <= 1 ? 2 : 3); }},
        {"reals among colours",
         {"f = \\begin{cases} (l, 0.5, 0) & l > v \\\\ v & l \\le v \\end{cases}"},
         [](double l, double v) { return l > v ? l : v; },
         [](double l, double v) { return l > v ? 0.5 : v; }},
        {"vectors",
         {"\\vec{w} = \\begin{cases} \\omega_i & l > v \\\\ \\omega_o & l \\le v \\end{cases}",
          "f = \\vec{w} \\cdot \\vec{n}"},
         [](double l, double v) { return std::max(l, v); }},
        {"a real parameter that takes a colour",
         {"g(x) = \\begin{cases} x^2 & l > v \\\\ 0 & \\text{else} \\end{cases}", "f = g((l, 3, 0))"},
         [](double l, double v) { return l > v ? l * l : 0; },
         [](double l, double v) { return l > v ? 9 : 0; }},
        {"in arithmetic and in each other",
         {"f = \\frac12 \\begin{cases} l & l > v \\\\ \\begin{cases} 1 & v > 0.5 \\\\ 2 \\end{cases} & \\text{else} "
          "\\end{cases} + 1"},
         [](double l, double v) { return 0.5 * (l > v ? l : (v > 0.5 ? 1 : 2)) + 1; }},
        {"the step function",
         {"f = \\chi^+(l - v) + 2\\chi^{+}\\!\\left(v - l\\right) + 4\\chi^+(0)"},
         [](double l, double v) { return (l > v ? 1 : 0) + (v > l ? 2 : 0); }},
        {"a step function of the document",
         {"\\chi^+(x) = 5x", "f = \\chi^{+}(l)"},
         [](double l, double) { return 5 * l; }},
        {"what is positive of it",
         {"f = (l - v)^+ + 2 [v - l]^{+}"},
         [](double l, double v) { return std::max(l - v, 0.0) + 2 * std::max(v - l, 0.0); }},
        {"a column",
         {"c = \\begin{pmatrix} 0.25 \\\\ 0.5 \\\\ 2 \\end{pmatrix}", "f = l c"},
         [](double l, double) { return 0.25 * l; },
         [](double l, double) { return 0.5 * l; }},
        {"a column that is a vector",
         {"\\mathbf{u} = \\begin{bmatrix} 0 & 0 & 1 \\end{bmatrix}", "f = \\mathbf{u} \\cdot \\omega_i"},
         [](double l, double) { return l; }},
    }));

}  // namespace
}  // namespace texbrdf::test
