// Names as papers write them: each pair of equations must have the same value for every direction.

#include "model.h"

namespace texbrdf::test {
namespace {

using eval::Triple;

struct Pair {
  const char* what;
  std::vector<std::string> written;  // the last one is the BRDF
  std::vector<std::string> expected;
};

void PrintTo(const Pair& pair, std::ostream* out) {
  *out << pair.what;
}

std::string document(const std::vector<std::string>& equations) {
  std::string text;
  for (const std::string& equation : equations) text += "\\begin{equation}" + equation + "\\end{equation}\n";
  return text;
}

std::vector<Triple> values(const std::vector<std::string>& equations) {
  const Result<eval::CompiledModel> model = compile_text(document(equations));
  if (!model) {
    ADD_FAILURE() << model.error();
    return {};
  }
  const eval::ReferenceEvaluator reference(model->unoptimised);
  std::vector<Triple> result;
  for (const ReferenceRow& row : read_reference("conventions")) {
    result.push_back(reference.evaluate(row.geometry, model->parameters));
  }
  return result;
}

class NamesOfPapers : public testing::TestWithParam<Pair> {};

TEST_P(NamesOfPapers, MeanTheSame) {
  const std::vector<Triple> written = values(GetParam().written);
  const std::vector<Triple> expected = values(GetParam().expected);
  ASSERT_EQ(written.size(), 200u);
  Deviation deviation(1e-12, 1e-12);
  for (std::size_t i = 0; i < written.size(); ++i) {
    deviation.compare(written[i], expected[i], "row " + std::to_string(i + 1));
  }
  EXPECT_LE(deviation.share(), 1) << deviation.first_failure();
}

INSTANTIATE_TEST_SUITE_P(
    Names, NamesOfPapers,
    testing::ValuesIn(std::vector<Pair>{
        {"decorations",
         {"\\mathbf q = \\omega_i", "f = \\hat{\\mathbf q} \\cdot {\\bf n} + \\bm q \\cdot \\boldsymbol{\\omega_o}"},
         {"\\vec{q} = \\omega_i", "f = \\vec{q} \\cdot \\vec{n} + \\vec{q} \\cdot \\omega_o"}},
        {"text, accents and primes",
         {"\\rho_{\\text{diff}} = 2", "\\bar\\mu = 3", "\\mu = 5", "v' = 7", "\\operatorname{mix}(x, y) = x - y",
          "f = \\rho_{diff} + \\mathrm{mix}(\\bar{\\mu}, \\mu) + v^\\prime"},
         {"f = 7"}},
        {"usual letters",
         {"f = (n \\cdot l) + 2 (N \\cdot V) + 3 (H \\cdot v) + 5 (t \\cdot L) + 7 (b \\cdot h)"},
         {"f = \\cos\\theta_i + 2 \\cos\\theta_o + 3 (\\vec{h} \\cdot \\omega_o) + 5 (\\vec{x} \\cdot \\omega_i) + 7 "
          "(\\vec{y} \\cdot \\vec{h})"}},
        {"usual bold letters",
         {"f = \\mathbf{m} \\cdot \\mathbf{i} + \\mathbf{o} \\cdot \\omega_g + \\omega_h \\cdot \\mathbf{V}"},
         {"f = \\vec{h} \\cdot \\omega_i + \\omega_o \\cdot \\vec{n} + \\vec{h} \\cdot \\omega_o"}},
        {"usual angles",
         {"f = \\theta_l + 2 \\theta_r + 3 \\theta_m + 5 \\varphi_i + 7 \\phi_v + 11 \\theta_{\\vec L}"},
         {"f = \\theta_i + 2 \\theta_o + 3 \\theta_h + 5 \\phi_i + 7 \\phi_o + 11 \\theta_i"}},
        {"the azimuth of the half vector",
         {"f = \\cos^2\\phi_h \\sin^2\\theta_h"},
         {"f = (\\vec{h} \\cdot \\vec{x})^2"}},
        {"a bold letter defined by what it usually is",
         {"\\mathbf i = \\omega_o", "n = 3", "f = (\\mathbf i \\cdot \\mathbf n)^n"},
         {"f = (\\omega_o \\cdot \\vec{n})^3"}},
        {"angles of parameters",
         {"D(\\mathbf m) = \\cos\\theta_m + \\phi_{\\mathbf m}", "G(\\mathbf v) = \\tan^2\\theta_v",
          "E(\\omega) = \\sin\\theta", "f = D(\\mathbf h) + G(\\mathbf l) + E(\\omega_o)"},
         {"f = \\cos\\theta_h + \\phi_h + \\tan^2\\theta_i + \\sin\\theta_o"}},
        {"a bold number", {"g(\\mathbf k) = \\exp\\mathbf k", "f = g(2)"}, {"f = \\exp 2"}},
    }));

}  // namespace
}  // namespace texbrdf::test
