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
        {"a normal and an exponent",
         {"n = 3", "l = 0.5",
          "f = (n \\cdot \\mathbf l)^n + l (n \\cdot (\\omega_i + \\omega_o)) + n \\cdot 2 + n \\cdot l"},
         {"f = \\cos^3\\theta_i + (\\cos\\theta_i + \\cos\\theta_o) / 2 + 7.5"}},
        {"directions that parameters are called",
         {"D(h) = (n \\cdot h)^2", "G(l, v) = (n \\cdot l)(n \\cdot v)", "f = D G"},
         {"f = \\cos^2\\theta_h \\cos\\theta_i \\cos\\theta_o"}},
        {"cosines of the directions",
         {"f = \\frac{\\mu_0}{\\mu_0 + \\mu}"},
         {"f = \\frac{\\cos\\theta_i}{\\cos\\theta_i + \\cos\\theta_o}"}},
        {"typed notes", {"f = N.L × 2 − \\mathbf{n}.\\mathbf{v} · 3"}, {"f = 2 \\cos\\theta_i - 3 \\cos\\theta_o"}},
        {"underlines",
         {"\\rho_{blinn\\_phong} = 2", "specular\\_color = 3", "f = \\rho_{\\text{blinn\\_phong}} specular\\_color"},
         {"f = 6"}},
        {"a mean",
         {"\\langle\\hat E_{\\text{F}}\\rangle = 0.5", "\\left\\langle G\\right\\rangle(x) = x^2", "s = -1",
          "f = \\langle \\hat{E}_F \\rangle^2 + \\langle G \\rangle(3) + \\langle s \\rangle"},
         {"f = 9.25"}},
        {"a vector and its direction",
         {"\\hat{\\mathbf q} = \\frac{\\mathbf q}{\\|\\mathbf q\\|}", "\\mathbf q = \\omega_i + \\omega_o",
          "g(\\mathbf p) = \\hat{\\mathbf q} \\cdot \\mathbf p",
          "f = \\hat{\\mathbf q} \\cdot \\omega_i + \\|\\vec q\\| + g(\\hat q)"},
         {"\\vec q = \\omega_i + \\omega_o", "f = \\vec{h} \\cdot \\omega_i + |\\vec q| + 1"}},
        {"a direction and its vector",
         {"\\hat q = \\omega_i + \\omega_o, \\quad \\vec q = \\hat q / |\\hat q|",
          "f = \\vec q \\cdot \\omega_i + |\\hat q|"},
         {"\\vec q = \\omega_i + \\omega_o", "f = \\vec{h} \\cdot \\omega_i + |\\vec q|"}},
        {"positive parts",
         {"x = \\cos\\theta_h - 0.9", "\\rho = (0.3, x, 0.2)", "g(y) = y_+ + y_{+}", "f = x_+ + g(-x) + 2\\rho_+"},
         {"x = \\cos\\theta_h - 0.9", "f = \\max(x, 0) + 2\\max(-x, 0) + 2(0.3, \\max(x, 0), 0.2)"}},
        {"a bold number", {"g(\\mathbf k) = \\exp\\mathbf k", "f = g(2)"}, {"f = \\exp 2"}},
    }));

INSTANTIATE_TEST_SUITE_P(
    ImpliedParameters, NamesOfPapers,
    testing::ValuesIn(std::vector<Pair>{
        {"what a function is made of",
         {"F(c) = g - c", "g = \\sqrt{2 + c^2}", "f = F(\\omega_i \\cdot \\vec{h}) + F(2)"},
         {"F(c) = \\sqrt{2 + c^2} - c", "f = F(\\omega_i \\cdot \\vec{h}) + F(2)"}},
        {"by others",
         {"F(c) = p - 1", "p = 2g", "g = 1 + c^2 + k", "k = 3", "f = F(\\omega_i \\cdot \\vec{h}) F(2)"},
         {"F(c) = 2(1 + c^2 + 3) - 1", "f = F(\\omega_i \\cdot \\vec{h}) F(2)"}},
        {"the angle of a direction",
         {"G(\\omega) = 1 + a^2", "a = \\frac{1}{3 + \\tan\\theta}", "f = G(\\omega_i) + 2G(\\omega_o)"},
         {"G(\\omega) = 1 + \\frac{1}{(3 + \\tan\\theta)^2}", "f = G(\\omega_i) + 2G(\\omega_o)"}},
        {"a name of the convention in the same display",
         {"G(\\mathbf v) = 1 + a \\\\ a = 2\\cos\\theta_v, \\quad b = \\theta_v",
          "f = G(\\omega_i) + 10G(\\omega_o) + 100b"},
         {"G(\\mathbf v) = 1 + 2\\cos\\theta_v", "f = G(\\omega_i) + 10G(\\omega_o) + 100\\theta_o"}},
        {"handed on in the display",
         {"G(\\mathbf v) = 1 + b \\\\ b = 3a, \\quad a = 2\\cos\\theta_v", "f = G(\\omega_i) + 10G(\\omega_o)"},
         {"G(\\mathbf v) = 1 + 6\\cos\\theta_v", "f = G(\\omega_i) + 10G(\\omega_o)"}},
        {"of a BRDF with its directions in another order",
         {"f(\\omega_o, \\omega_i) = a \\\\ a = \\cos\\theta_i"},
         {"f(\\omega_o, \\omega_i) = \\cos\\theta_i"}},
        {"and what the convention makes of one",
         {"G(\\omega_i) = a \\\\ a = \\cos\\theta_i", "f = G(\\omega_o)"},
         {"f = \\cos\\theta_o"}},
        {"not in another display",
         {"G(\\mathbf v) = a + \\mathbf v \\cdot \\mathbf n", "a = 2\\cos\\theta_v", "f = G(\\omega_i)"},
         {"f = 2\\cos\\theta_o + \\cos\\theta_i"}},
        {"of several functions",
         {"F(x) = g", "H(x) = 3g", "g = x^2", "f = F(2) + H(\\theta_h)"},
         {"f = 4 + 3\\theta_h^2"}},
        {"vectors",
         {"F(\\mathbf q) = c^2", "c = \\mathbf q \\cdot \\omega_i", "f = F(\\omega_o)"},
         {"f = (\\omega_i \\cdot \\omega_o)^2"}},
        {"of the BRDF itself",
         {"f(\\vec{p}, \\vec{q}) = c + 1", "c = \\vec{p} \\cdot \\vec{q}"},
         {"f = \\omega_i \\cdot \\omega_o + 1"}},
    }));

INSTANTIATE_TEST_SUITE_P(
    LeftSides, NamesOfPapers,
    testing::ValuesIn(std::vector<Pair>{
        {"an angle in a chain",
         {"c = \\cos\\theta = \\omega_i \\cdot \\vec{h}", "f = c + \\theta"},
         {"f = \\cos\\theta_d + \\theta_d"}},
        {"a square", {"g^2 = 2 + \\theta_h", "f = g + 1"}, {"f = \\sqrt{2 + \\theta_h} + 1"}},
        {"a square beside a definition", {"g^2 = 2", "g = 3", "f = g"}, {"f = 3"}},
        {"the cosine of an angle",
         {"\\cos\\xi = \\frac{\\omega_i \\cdot \\omega_o}{2}", "f = \\xi + \\cos\\xi"},
         {"c = \\frac{\\omega_i \\cdot \\omega_o}{2}", "f = \\arccos(c) + c"}},
        {"a parameter that is a cosine",
         {"p(\\cos\\theta, x) = \\frac{x + \\theta}{2 - \\cos\\theta}", "f = p(\\omega_i \\cdot \\vec{n}, 3)"},
         {"p(c, x) = \\frac{x + \\arccos(c)}{2 - c}", "f = p(\\omega_i \\cdot \\vec{n}, 3)"}},
        {"the cosine of an angle of the convention",
         {"F(\\cos\\theta_d) = \\theta_d + \\cos^2\\theta_d", "f = F(0.5)"},
         {"f = \\arccos(0.5) + 0.25"}},
        {"a BRDF of a cosine", {"f_r(\\cos\\theta_i) = 1 + \\cos\\theta_i"}, {"f = 1 + \\cos\\theta_i"}},
        {"a parameter that is an expression",
         {"F(v \\cdot h) = 1 - (v \\cdot h)^2", "f = F(0.5) + F(\\omega_i \\cdot \\vec{n})"},
         {"F(x) = 1 - x^2", "f = F(0.5) + F(\\omega_i \\cdot \\vec{n})"}},
        {"a BRDF of an expression",
         {"f_r(\\theta_i, |\\phi_i - \\phi_o|) = \\theta_i + |\\phi_i - \\phi_o| + \\phi_o"},
         {"f = \\theta_i + |\\phi_i - \\phi_o| + \\phi_o"}},
        {"the power of a call",
         {"a(x) = x + 1", "x = 2", "f = a^2(\\theta_i) + a^{3}(2) + \\cos a^2(1) + x^2(3)"},
         {"a(x) = x + 1", "f = a(\\theta_i)^2 + 27 + \\cos(4) + 12"}},
        {"superscripts that number",
         {"g^{(1)}(x) = x", "g^{(2)}(x) = x^2", "f = g^{(1)}(\\theta_i) + g^{(2)}(3)"},
         {"f = \\theta_i + 9"}},
        {"what is said again", {"h_r = h_r(\\omega_i) = \\theta_i", "f = h_r"}, {"f = \\theta_i"}},
        {"arguments that nothing reads",
         {"g(x, \\Lambda) = x", "k(x, y) = g(x, y)", "f(x, \\omega_i, \\omega_o) = k(\\theta_i, x) + k(2, \\lambda)"},
         {"f = \\theta_i + 2"}},
        {"directions that are not used",
         {"f_r(L, V) = \\frac{1}{N \\cdot L}"},
         {"f = \\frac{1}{\\vec{n} \\cdot \\omega_i}"}},
    }),
    [](const auto& test) { return "case_" + std::to_string(test.index); });

}  // namespace
}  // namespace texbrdf::test
