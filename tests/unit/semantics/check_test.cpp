#include <gtest/gtest.h>

#include "checked_text.h"

namespace texbrdf {
namespace {

struct Case {
  const char* what;
  std::vector<std::string> equations;  // the last one is looked at
  std::string signature;
  std::vector<std::string> reports;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.what;
}

class Check : public testing::TestWithParam<Case> {};

TEST_P(Check, GivesTypesAndReports) {
  const test::CheckedText text(GetParam().equations);
  EXPECT_EQ(signature_text(text.last().signature), GetParam().signature);
  EXPECT_EQ(text.reports(), GetParam().reports);
}

INSTANTIATE_TEST_SUITE_P(
    Expressions, Check,
    testing::ValuesIn(std::vector<Case>{
        {"number", {"a = 1"}, "ℝ", {}},
        {"vector literal", {"a = \\vec{1, -0.5, +.5}"}, "ℝ³", {}},
        {"sum", {"a = 1 + 2 - 3"}, "ℝ", {}},
        {"sum of vectors", {"a = \\vec{n} + \\vec{h} - \\omega_i"}, "ℝ³", {}},
        {"scaled", {"a = 2 * \\vec{n} * 3 / 4"}, "ℝ³", {}},
        {"dot product", {"a = \\vec{n} \\cdot \\vec{h}"}, "ℝ", {}},
        {"cross product", {"a = \\vec{n} \\times \\vec{h}"}, "ℝ³", {}},
        {"signs keep the type", {"a = -+-\\vec{n}"}, "ℝ³", {}},
        {"fraction", {"a = \\frac{\\vec{n}}{2}"}, "ℝ³", {}},
        {"functions", {"a = \\exp 1 + \\sqrt{2} + \\sqrt[3]{2} + \\max(1, 2, 3) + 2^3"}, "ℝ", {}},
        {"every convention",
         {"a = (\\theta_i + \\theta_o + \\phi_i + \\phi_o + \\theta_h + \\theta_d + \\pi + \\epsilon) * "
          "(\\vec{\\omega_i} + \\vec{\\omega_o})"},
         "ℝ³",
         {}},
        {"call", {"g(\\vec{a}, x) = x * \\vec{a}", "b = g(\\vec{n}, 2)"}, "ℝ³", {}},
        {"sum of vector and real",
         {"a = \\vec{n} + 1"},
         "?",
         {"E4001 [+] `+` between ℝ³ and ℝ: it needs two operands of the same type, or a colour and a real"}},
        {"difference",
         {"a = 1 - \\vec{n}"},
         "?",
         {"E4001 [-] `-` between ℝ and ℝ³: it needs two operands of the same type, or a colour and a real"}},
        {"division by a vector",
         {"a = 1 / \\vec{n}"},
         "?",
         {"E4001 [/] `/` between ℝ and ℝ³: it needs a real below the line, or a colour and no vector above it"}},
        {"fraction of vectors",
         {"a = \\frac{1}{\\vec{n}}"},
         "?",
         {"E4001 [\\frac] `\\frac` between ℝ and ℝ³: it needs a real below the line, or a colour and no vector above it"}},
        {"product of reals", {"a = 2 \\times 3"}, "ℝ", {}},
        {"power of vectors",
         {"a = \\vec{n}^{(\\vec{h})}"},
         "?",
         {"E4002 [\\vec{n}] operand of `^`: expected ℝ or RGB, got ℝ³",
          "E4002 [\\vec{h}] operand of `^`: expected ℝ or RGB, got ℝ³"}},
        {"root of a vector",
         {"a = \\sqrt[\\vec{h}]{4}"},
         "?",
         {"E4002 [\\vec{h}] operand of `\\sqrt`: expected ℝ or RGB, got ℝ³"}},
        {"maximum of a vector",
         {"a = \\max(1, {\\vec{n}})"},
         "?",
         {"E4002 [\\vec{n}] operand of `\\max`: expected ℝ or RGB, got ℝ³"}},
        {"no cascade upwards",
         {"a = \\exp(\\vec{n}) \\times \\vec{n} * (1 + \\exp(\\vec{h}) \\times 2)"},
         "ℝ³",
         {"E4002 [\\vec{n}] operand of `\\exp`: expected ℝ or RGB, got ℝ³",
          "E4002 [\\vec{h}] operand of `\\exp`: expected ℝ or RGB, got ℝ³"}},
        {"no cascade to users", {"a = \\vec{n} + 1", "b = \\exp(a) + a \\times 2 + \\vec{n}"}, "ℝ³", {}},
    }));

INSTANTIATE_TEST_SUITE_P(
    Cases, Check,
    testing::ValuesIn(std::vector<Case>{
        {"reals", {"a = \\begin{cases} 1 & \\theta_h > 0 \\\\ 2 \\end{cases}"}, "ℝ", {}},
        {"reals and colours", {"a = \\begin{cases} 1 & \\theta_h > 0 \\\\ (1, 2, 3) \\end{cases}"}, "RGB", {}},
        {"vectors and tuples", {"a = \\begin{cases} \\vec{n} & \\theta_h > 0 \\\\ (1, 2, 3) \\end{cases}"}, "ℝ³", {}},
        {"tuples", {"a = \\begin{cases} (0, 0, 1) & \\theta_h > 0 \\\\ (1, 2, 3) \\end{cases}"}, "ℝ³/RGB", {}},
        {"a vector and a real",
         {"a = \\begin{cases} \\vec{n} & \\theta_h > 0 \\\\ 0 \\end{cases}"},
         "?",
         {"E4032 [0] a row of ℝ below rows of ℝ³: all need the same type, or are reals and colours"}},
        {"compared with a vector",
         {"a = \\begin{cases} 1 & \\vec{n} > 0 \\\\ 0 \\end{cases}"},
         "ℝ",
         {"E4030 [\\vec{n}] operand of `>`: expected ℝ, got ℝ³"}},
        {"no condition",
         {"a = \\begin{cases} 1 & \\theta_h \\\\ 0 \\end{cases}"},
         "ℝ",
         {"E4031 [\\theta_h] expected a condition, got ℝ"}},
        {"a condition is no number",
         {"a = \\begin{cases} 1 & (\\theta_h > 0) + 1 > 2 \\\\ 2 & -(\\theta_h > 0) = 1 \\\\ 0 \\end{cases}"},
         "ℝ",
         {"E4001 [+] `+` between 𝔹 and ℝ: it needs two operands of the same type, or a colour and a real",
          "E4002 [\\theta_h > 0] operand of `-`: expected ℝ or RGB, got 𝔹"}},
        {"no cascade", {"b = \\vec{n} + 1", "a = \\begin{cases} 1 & |b| > 0 \\\\ b \\end{cases}"}, "ℝ", {}},
        {"a parameter that is a vector",
         {"g(x) = \\begin{cases} x \\cdot \\vec{n} + 1 & |x| > 1 \\\\ 0 \\end{cases}"},
         "ℝ³ → ℝ",
         {"E4005 [x] `x` is taken as a vector; write `\\vec{x}`"}},
        {"a parameter that is compared",
         {"g(\\mathbf{w}) = \\begin{cases} 1 & \\mathbf{w} > 0 \\\\ 0 \\end{cases}"},
         "ℝ → ℝ",
         {}},
        {"a letter that is compared is no direction",
         {"n = 2", "a = \\begin{cases} 1 & n > 1 \\\\ 0 \\end{cases}"},
         "ℝ",
         {}},
        {"the step function", {"a = \\chi^+(\\theta_h)"}, "ℝ", {}},
        {"the step function of a vector",
         {"a = \\chi^+(\\vec{n})"},
         "?",
         {"E4003 [\\vec{n}] 1st argument of `\\chi^+`: expected ℝ, got ℝ³"}},
        {"the step function as a value",
         {"a = 2 \\chi^+"},
         "?",
         {"E3005 [\\chi^+] `\\chi^+` is a function and stands here without arguments"}},
        {"a step function of the document", {"\\chi^+(\\vec{x}) = 2\\vec{x}", "a = \\chi^{+}(\\vec{n})"}, "ℝ³", {}},
    }));

INSTANTIATE_TEST_SUITE_P(
    Colours, Check,
    testing::ValuesIn(std::vector<Case>{
        {"tuple", {"a = (0.5, 1 - 0.25, \\pi)"}, "ℝ³/RGB", {}},
        {"a tuple stays one", {"a = -2 * (1, 2, 3) / 4 + (1, 1, 1) - (2, 1, 0)"}, "ℝ³/RGB", {}},
        {"beside a vector", {"a = \\vec{n} + (1, 0, 0)"}, "ℝ³", {}},
        {"dot product with a vector", {"a = (1, 0, 0) \\cdot \\vec{n}"}, "ℝ", {}},
        {"cross product", {"a = (1, 0, 0) \\times (0, 1, 0)"}, "ℝ³", {}},
        {"difference with a real", {"c = (1, 0.5, 0)", "a = 1 - c"}, "RGB", {}},
        {"product of two", {"c = (1, 0.5, 0)", "a = c * c"}, "RGB", {}},
        {"product of two, or a dot product",
         {"c = (1, 0.5, 0)", "a = 2 \\cdot c \\cdot c"},
         "RGB",
         {"E4023 [\\cdot] read as a product of colours, component by component; `*` says so, and a dot product needs a "
          "vector, `\\vec{…}`"}},
        {"side by side", {"c = (1, 0.5, 0)", "a = 2 c c"}, "RGB", {}},
        {"quotients", {"c = (1, 0.5, 0)", "a = c / (1 - c) + \\frac{1}{c}"}, "RGB", {}},
        {"power", {"c = (1, 0.5, 0)", "a = c^2 + 2^c + c^c"}, "RGB", {}},
        {"functions", {"c = (1, 0.5, 0)", "a = \\sqrt{c} \\exp(-c) + \\max(c, 0, 0.5) + \\sqrt[3]{c}"}, "RGB", {}},
        {"a function of reals that gives a colour", {"c = (1, 0.5, 0)", "a(x) = c + (1 - c)(1 - x)^5"}, "ℝ → RGB", {}},
        {"named as a vector", {"\\vec{t} = (1, 0.5, 0)", "a = \\vec{t} \\cdot \\vec{t}"}, "ℝ", {}},
        {"as a vector's argument", {"g(\\vec{a}) = \\vec{a} \\cdot \\vec{n}", "a = g((1, 0, 0))"}, "ℝ", {}},
        {"a parameter inside", {"g(x) = (x, 1, x^2)"}, "ℝ → ℝ³/RGB", {}},
        {"a parameter that is no component",
         {"g(x) = (x \\cdot \\vec{n}, 1, 1)"},
         "ℝ³ → ℝ³/RGB",
         {"E4005 [x] `x` is taken as a vector; write `\\vec{x}`"}},
        {"too short",
         {"a = (1, 2) + \\vec{n}"},
         "?",
         {"E4001 [+] `+` between ℝ² and ℝ³: it needs two operands of the same type"}},
        {"too long", {"a = (1, 2, 3, 4, 5)"}, "?", {"E4021 [(1, 2, 3, 4, 5)] a tuple has 2, 3 or 4 components, not 5"}},
        {"of vectors",
         {"a = (1, 2, (\\vec{n}))"},
         "?",
         {"E4022 [\\vec{n}] component of a tuple or matrix: expected ℝ, got ℝ³"}},
        {"of what is not known", {"p = q", "a = (1, p, 2)"}, "ℝ³/RGB", {}},
        {"colour and vector",
         {"c = (1, 0, 0)", "a = (c + 1) * \\vec{n}"},
         "?",
         {"E4001 [*] `*` between RGB and ℝ³: it needs a real, two vectors or two colours"}},
        {"colour and vector side by side",
         {"c = (1, 0, 0)", "a = (c + 1) \\vec{n}"},
         "?",
         {"E4001 [\\vec{n}] `\\cdot` between RGB and ℝ³: it needs a real, two vectors or two colours"}},
        {"vector and tuple side by side", {"a = \\vec{n} (1, 0, 0)"}, "?", {"E3012 [(] missing operator"}},
        {"a vector below a tuple",
         {"a = (1, 0, 0) / \\vec{n}"},
         "?",
         {"E4001 [/] `/` between ℝ³/RGB and ℝ³: it needs a real below the line, or a colour and no vector above it"}},
        {"a colour for a real parameter", {"g(x) = x / (1 + x)", "a = g((1, 2, 3))"}, "RGB", {}},
        {"some colours for real parameters",
         {"g(x, y, z) = x + (y - x)(1 - z)^5", "c = (1, 0, 0)",
          "a = g(c, 1, 0.5) + g(0.04, c, \\vec{n} \\cdot \\vec{h}) + g(1, c, c)"},
         "RGB",
         {}},
        {"through another function", {"g(x) = \\sqrt{x}", "h(x, y) = g(x) + y", "a = h((1, 2, 3), 1)"}, "RGB", {}},
        {"a function of a tuple", {"g(x) = x * (1, 0.5, 0)", "a = g((1, 2, 3))"}, "RGB", {}},
        {"a parameter that scales a vector",
         {"g(x) = (x * \\vec{n}) \\cdot \\vec{h}", "c = (1, 2, 3)^2", "a = g(c)"},
         "?",
         {"E4003 [c] 1st argument of `g`: expected ℝ, got RGB"}},
        {"a vector for a real parameter",
         {"g(x) = \\cos x", "a = g(\\vec{n})"},
         "?",
         {"E4003 [\\vec{n}] 1st argument of `g`: expected ℝ, got ℝ³"}},
        {"a colour for what is also a component",
         {"g(x) = (x, 1, 1)", "c = (1, 2, 3)", "a = g(c)"},
         "?",
         {"E4003 [c] 1st argument of `g`: expected ℝ, got ℝ³/RGB"}},
        {"perhaps a colour for a real parameter", {"p = q", "g(x) = \\exp x", "a = g(p)"}, "?", {}},
        {"a parameter of a function that takes colours",
         {"g(x) = \\exp x", "c = (1, 2, 3)", "a(x) = g(c x) + g(x)"},
         "ℝ → RGB",
         {}},
    }));

INSTANTIATE_TEST_SUITE_P(
    NamesOfPapers, Check,
    testing::ValuesIn(std::vector<Case>{
        {"bold and hats",
         {"\\mathbf q = \\vec{1,0,0}", "a = \\hat q \\cdot {\\bf q} + \\bm{q} \\cdot \\vec q"},
         "ℝ",
         {}},
        {"upright subscripts", {"\\rho_{\\text{diff}} = 1", "a = \\rho_{diff} + \\rho_{\\mathrm{diff}}"}, "ℝ", {}},
        {"an accent",
         {"\\mu = 1", "a = \\mu + \\bar\\mu"},
         "ℝ",
         {"E3001 [\\bar\\mu] undefined name `\\bar{\\mu}` in the definition of `a`"}},
        {"primes", {"v' = 1", "a = v' + v^\\prime"}, "ℝ", {}},
        {"told as it is written",
         {"a = \\mathbf q \\times \\vec{n}"},
         "ℝ³",
         {"E3001 [\\mathbf q] undefined name `\\mathbf q` in the definition of `a`"}},
        {"what papers leave undefined",
         {"a = n \\cdot l + \\mathbf v \\cdot \\hat h + \\theta_l + \\phi_h + \\varphi_o"},
         "ℝ",
         {}},
        {"the scalar beside the vector", {"n = 3", "a = (\\mathbf n \\cdot \\mathbf h)^n"}, "ℝ", {}},
        {"bold by its own meaning", {"\\mathbf i = \\omega_i", "a = \\mathbf i \\cdot n"}, "ℝ", {}},
        {"no direction in a power",
         {"a = (n \\cdot l)^n"},
         "?",
         {"E3001 [n] undefined name `n` in the definition of `a`",
          "E3001 [n] undefined name `n` in the definition of `a`"}},
        {"no direction beside a number", {"a = 1 - h"}, "ℝ", {"E3001 [h] undefined name `h` in the definition of `a`"}},
        {"angle of a parameter",
         {"D(\\mathbf m) = \\cos\\theta_m + \\phi_{\\mathbf m} + \\theta_m(1 - \\theta_m)"},
         "ℝ³ → ℝ",
         {}},
        {"an angle makes a vector",
         {"D(q) = \\cos\\theta_q"},
         "ℝ³ → ℝ",
         {"E4005 [q] `q` is taken as a vector; write `\\vec{q}`"}},
        {"roughness is no direction", {"D(r) = r \\cos\\theta_r"}, "ℝ → ℝ", {}},
        {"a bare angle", {"D(\\hat h, r) = r \\tan\\theta"}, "ℝ³ × ℝ → ℝ", {}},
        {"a bare angle of two",
         {"D(\\hat h, \\hat q) = (\\hat h \\cdot \\hat q) \\theta"},
         "ℝ³ × ℝ³ → ?",
         {"E3001 [\\theta] undefined name `\\theta` in the definition of `D`"}},
        {"a bold number", {"g(\\mathbf k) = \\exp\\mathbf k"}, "ℝ → ℝ", {}},
        {"an arrow is a vector",
         {"g(\\vec k) = \\exp\\vec k"},
         "ℝ³ → ?",
         {"E4002 [\\vec k] operand of `\\exp`: expected ℝ or RGB, got ℝ³"}},
    }));

// `p` stands for what is not known, because it is defined in error.
INSTANTIATE_TEST_SUITE_P(
    TypesThatErrorsLeaveKnown, Check,
    testing::ValuesIn(std::vector<Case>{
        {"sum with a real", {"p = q", "a = p + 1"}, "ℝ", {}},
        {"difference with a vector", {"p = q", "a = \\vec{n} - p"}, "ℝ³", {}},
        {"sum of nothing known", {"p = q", "a = p + p"}, "?", {}},
        {"product", {"p = q", "a = 2 * p"}, "?", {}},
        {"dot product, or scaled", {"p = q", "a = \\vec{n} \\cdot p"}, "?", {}},
        {"above a line", {"p = q", "a = \\frac{p}{2}"}, "?", {}},
        {"below a line", {"p = q", "a = \\frac{2}{p} + \\theta_h"}, "ℝ", {}},
        {"below a vector", {"p = q", "a = \\vec{n} / p"}, "ℝ³", {}},
        {"a vector below what is not known", {"p = q", "a = p / \\vec{n}"}, "?", {}},
        {"cross product", {"p = q", "a = p \\times p"}, "ℝ³", {}},
        {"cross product with a real", {"p = q", "a = 2 \\times p"}, "?", {}},
        {"power", {"p = q", "a = p^p"}, "?", {}},
        {"power of a colour", {"p = q", "c = (1, 0, 0)", "a = c^p + p"}, "RGB", {}},
        {"power of a vector", {"p = q", "a = \\vec{n}^p"}, "?", {}},
        {"functions", {"p = q", "a = \\sin(p) + \\max(p, p) + \\sqrt[p]{p}"}, "?", {}},
        {"functions of a colour", {"p = q", "c = (1, 0, 0)", "a = \\max(c, p)"}, "RGB", {}},
        {"functions with another fault",
         {"p = q", "a = \\max(p, \\vec{n})"},
         "?",
         {"E4002 [\\vec{n}] operand of `\\max`: expected ℝ or RGB, got ℝ³"}},
        {"calls", {"p = q", "g(\\cos x) = \\cos x * \\vec{n}", "a = g(p)"}, "ℝ³", {}},
        {"calls that may be of a vector", {"p = q", "g(x) = x * \\vec{n}", "a = g(p)"}, "?", {}},
        {"calls with too few arguments",
         {"p = q", "g(x, y) = x * y", "a = g(p)"},
         "?",
         {"E4004 [g(p)] `g` takes 2 arguments, got 1"}},
        {"in a function of undecided parameters", {"p = q", "g(x) = x \\times p + \\vec{n}"}, "? → ℝ³", {}},
        {"not by what a parameter might be", {"p = q", "g(x) = x + p"}, "? → ?", {}},
        {"a function in error", {"g(x) = q \\times (x\\vec{n})", "a = g(1)"}, "ℝ³", {}},
        {"a chain behind an error", {"p = q", "a = p \\times p", "b = a * \\vec{n}"}, "ℝ", {}},
        {"what no value of the unknown mends is left to its own definition", {"p = q", "a = p \\times p + 1"}, "?", {}},
        {"but it is told to users",
         {"p = q", "a = p \\times p", "b = 1 + a"},
         "?",
         {"E4001 [+] `+` between ℝ and ℝ³: it needs two operands of the same type, or a colour and a real"}},
        {"nothing of what cannot be read", {"a = (1 + 2"}, "?", {}},
    }));

INSTANTIATE_TEST_SUITE_P(
    Names, Check,
    testing::ValuesIn(std::vector<Case>{
        {"undefined", {"a = q + 1"}, "ℝ", {"E3001 [q] undefined name `q` in the definition of `a`"}},
        {"undefined in a call", {"a = q(1)"}, "?", {"E3001 [q] undefined name `q` in the definition of `a`"}},
        {"undefined twice has two places",
         {"a = q + q"},
         "?",
         {"E3001 [q] undefined name `q` in the definition of `a`",
          "E3001 [q] undefined name `q` in the definition of `a`"}},
        {"undefined Greek letter",
         {"a = \\alpha"},
         "?",
         {"E3001 [\\alpha] undefined name `\\alpha` in the definition of `a`"}},
        {"reserved word",
         {"a = arccos"},
         "?",
         {"E3002 [arccos] `arccos` is a reserved word; the command is `\\arccos`"}},
        {"reserved word with groups",
         {"a = frac{1}{2}"},
         "?",
         {"E3002 [frac] `frac` is a reserved word; the command is `\\frac`"}},
        {"reserved word with an operand", {"a = sin 2 + cos^2(1) + max(1, \\mathrm{sin} 1)"}, "ℝ", {}},
        {"function of the language by a word",
         {"a = \\text{saturate}(dot(n, \\omega_i)) + \\operatorname{mix}(1, 2, 3)"},
         "ℝ",
         {}},
        {"function of the language of a colour", {"c = (1, 2, 3) + 0", "a = \\text{clamp}(c, 0, c)"}, "RGB", {}},
        {"vector function of the language", {"a = \\text{normalize}(\\omega_i + \\omega_o)"}, "ℝ³", {}},
        {"function of the language with too few arguments",
         {"a = \\text{clamp}(1, 2)"},
         "?",
         {"E4004 [\\text{clamp}(1, 2)] `\\text{clamp}` takes 3 arguments, got 2"}},
        {"function of the language with a vector",
         {"a = \\text{saturate}(\\omega_i)"},
         "?",
         {"E4003 [\\omega_i] 1st argument of `\\text{saturate}`: expected ℝ, got ℝ³"}},
        {"function of the language defined by the document",
         {"\\text{abs}(x) = \\omega_i x", "a = \\text{abs}(2)"},
         "ℝ³",
         {}},
        {"angle in degrees", {"a = 20^\\circ + \\sin 3^{\\circ}x", "a = 2"}, "ℝ", {}},
        {"logarithm to a base", {"a = \\log_2 8 + \\log_{10}(3)"}, "ℝ", {}},
        {"function without arguments takes what they are called",
         {"D(\\vec{h}) = \\vec{h} \\cdot n", "F(x) = x^2", "x = (1, 2, 3) + 0", "a = D F"},
         "RGB",
         {}},
        {"function without arguments of which one means nothing",
         {"F(q) = q^2", "a = F"},
         "?",
         {"E3005 [F] `F` is a function and stands here without arguments"}},
        {"function without arguments takes a parameter", {"F(q) = q^2", "a(q) = F + 1"}, "ℝ → ℝ", {}},
        {"component", {"a = \\vec{h}_x^2 + \\omega_{i_z} + h_y"}, "ℝ", {}},
        {"component of a bold parameter", {"a(\\mathbf{h}) = h_x"}, "ℝ³ → ℝ", {}},
        {"component of a parameter",
         {"a(u) = u_x + u_z"},
         "ℝ³ → ℝ",
         {"E4005 [u] `u` is taken as a vector; write `\\vec{u}`"}},
        {"component of a number",
         {"k = 2", "a = k_x"},
         "?",
         {"E3001 [k_x] undefined name `k_x` in the definition of `a`"}},
        {"angle of a vector of the document",
         {"\\vec{m} = \\omega_i \\times \\omega_o", "a = \\theta_m + \\phi_m"},
         "ℝ",
         {}},
        {"product of letters", {"r = 2", "t = 3", "a = 1 + rt^2"}, "ℝ", {}},
        {"product of longer names", {"ab = 2", "a = 3", "b = 4", "c = 5", "d = abca"}, "ℝ", {}},
        {"product of letters with a prime and a subscript", {"v = 2", "v' = 3", "k_1 = 4", "a = vv' + vk_1"}, "ℝ", {}},
        {"product of letters of which one is unknown",
         {"r = 2", "a = rt"},
         "?",
         {"E3001 [rt] undefined name `rt` in the definition of `a`"}},
        {"difference as a name", {"\\Delta\\phi = \\phi_i - \\phi_o", "a = \\cos\\Delta\\phi"}, "ℝ", {}},
        {"factor before a name", {"\\Delta = 2", "x = 3", "a = \\Delta x"}, "ℝ", {}},
        {"reserved word defined", {"max = 1"}, "ℝ", {"E3002 [max] `max` is a reserved word; the command is `\\max`"}},
        {"reserved word as parameter",
         {"g(max) = max"},
         "? → ?",
         {"E3002 [max] `max` is a reserved word; the command is `\\max`"}},
        {"reserved words in subscripts are none",
         {"x_{max} = \\text{max}"},
         "?",
         {"E3001 [\\text{max}] undefined name `\\text{max}` in the definition of `x_{max}`"}},
        {"unknown command", {"a = \\foo + 1"}, "ℝ", {"E3003 [\\foo] unknown command `\\foo`"}},
        {"unknown command with groups",
         {"a = \\foo{q}{\\vec{n} + 1} * 2"},
         "?",
         {"E3003 [\\foo] unknown command `\\foo`"}},
        {"unknown command behind an operand", {"a = 2\\foo"}, "?", {"E3003 [\\foo] unknown command `\\foo`"}},
        {"a command that is defined", {"\\foo = 1", "a = \\foo"}, "ℝ", {}},
        {"a command that is a parameter", {"g(\\foo) = \\foo"}, "ℝ → ℝ", {}},
        {"two vectors side by side", {"a = \\vec{n}\\vec{h}"}, "?", {"E3012 [\\vec{h}] missing operator"}},
        {"calling a value with several arguments",
         {"k = 2", "a = k(3, 4)"},
         "?",
         {"E3004 [k] `k` is called but is no function"}},
        {"the power of a function is no call, whatever means nothing before it",
         {"g(x) = x", "a = \\cos&^&g(1)"},
         "ℝ",
         {"E3005 [g] `g` is a function and stands here without arguments"}},
        {"the power of a function is no call",
         {"g(x) = x", "a = \\cos^g(1)"},
         "ℝ",
         {"E3005 [g] `g` is a function and stands here without arguments"}},
        {"function as a value",
         {"g(x) = x", "a = g + 1"},
         "ℝ",
         {"E3005 [g] `g` is a function and stands here without arguments"}},
        {"redefined constant", {"\\pi = 3"}, "ℝ", {"E3007 [\\pi] `\\pi` is a constant and cannot be redefined"}},
        {"redefined epsilon as a function",
         {"\\epsilon(x) = x"},
         "? → ?",
         {"E3007 [\\epsilon] `\\epsilon` is a constant and cannot be redefined"}},
        {"repeated parameter",
         {"g(x, y, x) = y"},
         "? × ? × ? → ?",
         {"E3011 [x] parameter `x` stands here for the second time"}},
        {"repeated parameter in another spelling",
         {"g(\\omega_i, \\vec{\\omega_i}) = 1"},
         "ℝ³ × ℝ³ → ℝ",
         {"E3011 [\\vec{\\omega_i}] parameter `\\omega_i` stands here for the second time"}},
    }));

INSTANTIATE_TEST_SUITE_P(Products, Check,
                         testing::ValuesIn(std::vector<Case>{
                             {"of reals", {"a = 2 \\pi \\theta_i"}, "ℝ", {}},
                             {"of a real and a vector", {"a = 2 \\vec{n}"}, "ℝ³", {}},
                             {"of a vector and a real", {"a = \\vec{n} 2"}, "ℝ³", {}},
                             {"of a number and a bracket", {"a = 2(1 + 3)"}, "ℝ", {}},
                             {"of a value and a bracket", {"k = 2", "a = k(3)"}, "ℝ", {}},
                             {"of a convention and a bracket", {"a = \\pi(\\vec{n})"}, "ℝ³", {}},
                             {"of a parameter and a bracket", {"g(x) = x(3)"}, "ℝ → ℝ", {}},
                             {"of a parameter that hides a function", {"g(x) = x", "h(g) = g(3)"}, "ℝ → ℝ", {}},
                             {"a function is called", {"g(x) = \\vec{n}", "a = 2g(3)"}, "ℝ³", {}},
                             {"in a power", {"k = \\vec{n}", "a = k(3)^2"}, "ℝ³", {}},
                             {"which a parameter's type follows",
                              {"g(x) = x(3) + \\vec{n}"},
                              "ℝ³ → ℝ³",
                              {"E4005 [x] `x` is taken as a vector; write `\\vec{x}`"}},
                         }));

INSTANTIATE_TEST_SUITE_P(
    Calls, Check,
    testing::ValuesIn(std::vector<Case>{
        {"too few", {"g(a, x) = a*x", "f = g(1)"}, "?", {"E4004 [g(1)] `g` takes 2 arguments, got 1"}},
        {"too many", {"g(a) = a", "f = 1 + g(1, 2, 3)"}, "ℝ", {"E4004 [g(1, 2, 3)] `g` takes 1 argument, got 3"}},
        {"wrong argument",
         {"g(a, x) = a^x", "f = g(1, ((\\vec{n})))"},
         "?",
         {"E4003 [\\vec{n}] 2nd argument of `g`: expected ℝ, got ℝ³"}},
        {"wrong third argument",
         {"g(a, b, \\vec{c}) = a*b*\\vec{c}", "f = g(1, 2, 3)"},
         "?",
         {"E4003 [3] 3rd argument of `g`: expected ℝ³, got ℝ"}},
        {"faults inside arguments",
         {"g(a) = a", "f = g(q)"},
         "?",
         {"E3001 [q] undefined name `q` in the definition of `f`"}},
        {"poisoned parameters take anything", {"g(x) = x \\times \\text{p}", "f = g(\\vec{n}) + g(1)"}, "ℝ³", {}},
        {"known parameters of a function in error",
         {"g(\\vec{x}) = \\vec{x} + 1", "f = g(1)"},
         "?",
         {"E4003 [1] 1st argument of `g`: expected ℝ³, got ℝ"}},
    }));

INSTANTIATE_TEST_SUITE_P(
    Parameters, Check,
    testing::ValuesIn(std::vector<Case>{
        {"all real", {"g(a, b) = a * b"}, "ℝ × ℝ → ℝ", {}},
        {"by spelling",
         {"g(\\vec{a}, \\omega_i, \\omega_o) = \\vec{a} + \\omega_i + \\omega_o"},
         "ℝ³ × ℝ³ × ℝ³ → ℝ³",
         {}},
        {"unused ones are real",
         {"g(a, b) = 1"},
         "ℝ × ℝ → ℝ",
         {"E3014 [a] the parameter `a` is not used", "E3014 [b] the parameter `b` is not used"}},
        {"those that are called as directions are vectors",
         {"g(L, V, t) = 1"},
         "ℝ³ × ℝ³ × ℝ → ℝ",
         {"E3014 [t] the parameter `t` is not used"}},
        {"a cosine is real", {"p(\\cos\\theta, \\tan\\beta) = \\theta + \\cos\\theta + \\beta"}, "ℝ × ℝ → ℝ", {}},
        {"an expression is what the body needs",
         {"F(a - b, c \\cdot d) = (a - b) \\cdot \\vec{n} + (c \\cdot d)^2"},
         "ℝ³ × ℝ → ℝ",
         {}},
        {"directions are what a BRDF takes, used or not", {"f(\\omega_i, \\omega_o) = 1"}, "ℝ³ × ℝ³ → ℝ", {}},
        {"a vector where the body needs one",
         {"g(x) = x \\times \\vec{n}"},
         "ℝ³ → ℝ³",
         {"E4005 [x] `x` is taken as a vector; write `\\vec{x}`"}},
        {"fewest vectors",
         {"g(a, b) = a * (b \\cdot \\vec{n}) + b \\times \\vec{n} \\cdot \\vec{n}"},
         "ℝ × ℝ³ → ℝ",
         {"E4005 [b] `b` is taken as a vector; write `\\vec{b}`"}},
        {"of equally few the leftmost",
         {"g(a, b) = a * b + \\vec{n}"},
         "ℝ³ × ℝ → ℝ³",
         {"E4005 [a] `a` is taken as a vector; write `\\vec{a}`"}},
        {"leftmost pair",
         {"g(a, b, c, d) = a * b + \\vec{n} * (c * d + \\vec{n})"},
         "ℝ × ℝ × ℝ³ × ℝ → ℝ",
         {"E4005 [c] `c` is taken as a vector; write `\\vec{c}`"}},
        {"all of them",
         {"g(a, b, c) = (a + b + c) \\times \\vec{n}"},
         "ℝ³ × ℝ³ × ℝ³ → ℝ³",
         {"E4005 [a] `a` is taken as a vector; write `\\vec{a}`",
          "E4005 [b] `b` is taken as a vector; write `\\vec{b}`",
          "E4005 [c] `c` is taken as a vector; write `\\vec{c}`"}},
        {"through a call",
         {"h(\\vec{x}) = \\vec{x} \\cdot \\vec{n}", "g(y) = h(y)"},
         "ℝ³ → ℝ",
         {"E4005 [y] `y` is taken as a vector; write `\\vec{y}`"}},
        {"nothing checks: the all-real reading",
         {"g(x) = \\exp(x) + x \\times \\vec{n}"},
         "? → ℝ³",
         {"E4001 [+] `+` between ℝ and ℝ³: it needs two operands of the same type, or a colour and a real"}},
        {"an error elsewhere leaves it open",
         {"g(x) = x \\times \\text{p}"},
         "? → ℝ³",
         {"E3001 [\\text{p}] undefined name `\\text{p}` in the definition of `g`"}},
        {"poison leaves it open", {"p = q", "g(x, \\vec{y}) = x \\times p"}, "? × ℝ³ → ℝ³", {}},
        {"hides a definition", {"b = \\vec{n}", "g(b) = b + 1"}, "ℝ → ℝ", {}},
        {"hides a function", {"b(x) = x", "g(b) = b + 1"}, "ℝ → ℝ", {}},
        {"hides conventions, constants too", {"s(\\theta_h, \\pi) = \\theta_h + 2 * \\pi"}, "ℝ × ℝ → ℝ", {}},
        {"hides the convention in its other spelling",
         {"g(\\omega_i) = \\vec{\\omega_i} \\cdot \\vec{n}"},
         "ℝ³ → ℝ",
         {}},
    }));

TEST(CheckDefinition, ParametersShadowConventions) {
  const test::CheckedText text({"g(\\vec{\\omega_o}, \\vec{n}, x) = \\cos\\theta_o * x"});
  const auto& parameters = text.last().parameters;
  ASSERT_EQ(parameters.size(), 3u);
  EXPECT_EQ(parameters[0].shadowed, std::vector{Convention::OmegaO});
  EXPECT_EQ(parameters[1].shadowed, std::vector{Convention::Normal});
  EXPECT_TRUE(parameters[2].shadowed.empty());
  EXPECT_FALSE(parameters[0].inferred);
  EXPECT_TRUE(parameters[2].inferred);
}

TEST(CheckDefinition, TheVectorFixWrapsEveryOccurrence) {
  const test::CheckedText text({"g(x, y) = y * x \\times \\vec{n} + x"});
  ASSERT_EQ(text.last().diagnostics.size(), 1u);
  const Diagnostic& hint = text.last().diagnostics[0];
  EXPECT_EQ(hint.severity, Severity::Hint);
  ASSERT_EQ(hint.fixes.size(), 1u);
  ASSERT_EQ(hint.fixes[0].edits.size(), 3u);
  for (const Edit& edit : hint.fixes[0].edits) {
    EXPECT_EQ(text.block().slice(edit.where.span), "x");
    EXPECT_EQ(edit.replacement, "\\vec{x}");
  }
}

TEST(CheckDefinition, FixesSayWhatToInsert) {
  const test::CheckedText product({"a = \\vec{n} \\vec{h}"});
  ASSERT_EQ(product.last().diagnostics.at(0).fixes.size(), 1u);
  const Edit& dot = product.last().diagnostics[0].fixes[0].edits.at(0);
  EXPECT_TRUE(dot.where.span.empty());
  EXPECT_EQ(dot.where.span.begin, product.last().diagnostics[0].where.span.begin);
  EXPECT_EQ(dot.replacement, "\\cdot ");

  const test::CheckedText word({"a = \\vec{max}"});
  const Edit& backslash = word.last().diagnostics.at(0).fixes.at(0).edits.at(0);
  EXPECT_EQ(word.block().text.substr(backslash.where.span.begin, 3), "max");
  EXPECT_EQ(backslash.replacement, "\\");
}

TEST(CheckDefinition, RepeatedParametersPointAtTheFirst) {
  const test::CheckedText text({"g(x, y, x) = y"});
  ASSERT_EQ(text.last().diagnostics.at(0).related.size(), 1u);
  EXPECT_LT(text.last().diagnostics[0].related[0].where.span.begin, text.last().diagnostics[0].where.span.begin);
}

TEST(CheckDefinition, AFunctionOfManyParametersIsDecidedQuickly) {
  std::string left = "g(";
  std::string body;
  for (char c = 'a'; c <= 'z'; ++c) {
    left += std::string(c == 'a' ? "" : ",") + "p_" + c;
    body += std::string(c == 'a' ? "" : "+") + "p_" + c + "\\times \\vec{n}";
  }
  const test::CheckedText text({left + ") = " + body});
  EXPECT_TRUE(text.last().sound);
  for (const CheckedParameter& parameter : text.last().parameters) EXPECT_EQ(parameter.type, Type::Vector);
}

TEST(CheckDefinition, GivesUpOnAPuzzleOfManyParameters) {
  // Products of three say only how many of them are vectors, and no choice satisfies all sums.
  std::string left = "g(";
  std::string body = "0";
  const int count = 40;
  for (int i = 0; i < count; ++i) {
    left += (i == 0 ? "p_{" : ",p_{") + std::to_string(i) + "}";
    const auto name = [&](int k) { return "p_{" + std::to_string((i + k) % count) + "}"; };
    body += "+ \\vec{n} \\cdot (" + name(0) + "*" + name(7) + "*" + name(17) + " + \\vec{n})";
  }
  body += " + \\exp(p_{0} * p_{1} * \\vec{n}) + \\exp(p_{0} * p_{1})";
  const test::CheckedText text({left + ") = " + body});
  EXPECT_FALSE(text.last().sound);
  EXPECT_FALSE(text.last().diagnostics.empty());
}

TEST(MentionedNames, AreThoseOfTheBodyThatNoParameterHidesEachOnce) {
  const std::string text = "\\begin{equation}g(x) = a + x * a + b\n\\end{equation}";
  const ParsedBlock block = parse_block(text, scan_blocks(text).at(0));
  NameTable table;
  const BlockNames names = read_names(block, table);
  const SmallNameMap mentioned = mentioned_names(block, block.definitions.at(0), names);
  std::string text_of_names;
  for (const NameId name : mentioned.names()) text_of_names += table.text(name);
  EXPECT_EQ(text_of_names, "ab");
}

TEST(SmallNameMap, FindsFewNamesAndMany) {
  SmallNameMap map;
  for (uint32_t i = 0; i < 100; ++i) {
    EXPECT_FALSE(map.find(NameId{3 * i}));
    EXPECT_TRUE(map.insert(NameId{3 * i}));
    EXPECT_FALSE(map.insert(NameId{3 * i}));
    EXPECT_EQ(map.names().size(), i + 1);
    for (uint32_t j = 0; j <= i; ++j) ASSERT_EQ(map.find(NameId{3 * j}), j);
  }
}

TEST(CheckDefinition, IsSoundWhereItCanBeLowered) {
  EXPECT_TRUE(test::CheckedText({"a = 1"}).last().sound);
  EXPECT_FALSE(test::CheckedText({"a = q + 1"}).last().sound);
  EXPECT_FALSE(test::CheckedText({"p = q", "a = p + 1"}).last().sound);
  EXPECT_FALSE(test::CheckedText({"p = q", "g(x) = x + 1 + p"}).last().sound);
  EXPECT_TRUE(test::CheckedText({"a = q + 1", "b = a + 1"}).last().sound);
}

}  // namespace
}  // namespace texbrdf
