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

class Instances : public testing::TestWithParam<Case> {};

TEST_P(Instances, GiveTypesAndReports) {
  const test::CheckedText text(GetParam().equations);
  EXPECT_EQ(signature_text(text.last().signature), GetParam().signature);
  EXPECT_EQ(text.reports(), GetParam().reports);
}

INSTANTIATE_TEST_SUITE_P(
    Calls, Instances,
    testing::ValuesIn(std::vector<Case>{
        {"by themselves they are what they were", {"g(x, y) = x \\cdot y"}, "ℝ × ℝ → ℝ", {}},
        {"of vectors", {"g(x, y) = x \\cdot y", "a = g(\\vec{n}, \\vec{h})"}, "ℝ", {}},
        {"of a number and a vector", {"g(x, y) = x \\cdot y", "a = g(2, \\vec{h})"}, "ℝ³", {}},
        {"of colours that no component has", {"d(x) = |x|", "c = (1, 0, 0)^2", "a = d(c) \\vec{n}"}, "ℝ³", {}},
        {"through a second function", {"g(x) = 2x", "k(y) = g(y)", "a = k(\\vec{n})"}, "ℝ³", {}},
        {"with a cosine of its own", {"g(x, \\cos t) = x \\cos t", "a = g(\\vec{n}, 0.5)"}, "ℝ³", {}},
        {"in a body that decides by them",
         {"g(x, y) = x \\cdot y", "k(a) = g(a, \\vec{n}) + 1"},
         "ℝ³ → ℝ",
         {"E4005 [a] `a` is taken as a vector; write `\\vec{a}`"}},
        {"in a body that may be of numbers", {"g(x, y) = x \\cdot y", "k(a) = g(a, \\vec{n})"}, "ℝ → ℝ³", {}},
        {"directions that a BRDF hands on",
         {"g(x, y) = x \\cdot y", "f_r(l, v) = g(l, v) / \\pi"},
         "ℝ³ × ℝ³ → ℝ",
         {"E4005 [l] `l` is taken as a vector; write `\\vec{l}`",
          "E4005 [v] `v` is taken as a vector; write `\\vec{v}`"}},
        {"or numbers, where those make no sense",
         {"g(x, y) = \\exp(x) y", "f_r(l, v) = g(l, v) / \\pi"},
         "ℝ × ℝ → ℝ",
         {}},
        {"where the body does not fit",
         {"g(x) = \\exp(x)", "a = g(\\vec{n})"},
         "?",
         {"E4003 [\\vec{n}] 1st argument of `g`: expected ℝ, got ℝ³"}},
        {"not of vectors for a product of numbers",
         {"g(a, x) = a*x*x", "f = g(1, \\vec{n})"},
         "?",
         {"E4003 [\\vec{n}] 2nd argument of `g`: expected ℝ, got ℝ³"}},
        {"beside a product of other vectors", {"g(x) = \\vec{n} * \\vec{h} \\cdot x", "f = g(\\vec{n})"}, "ℝ³", {}},
        {"where a function within does not fit",
         {"g(x) = \\exp(x)", "k(y) = g(y)", "a = k(\\vec{n})"},
         "?",
         {"E4003 [\\vec{n}] 1st argument of `k`: expected ℝ, got ℝ³"}},
        {"not of what is written as a vector",
         {"g(\\vec x) = 2 \\vec x", "a = g(2)"},
         "?",
         {"E4003 [2] 1st argument of `g`: expected ℝ³, got ℝ"}},
        {"not of a number for what is bold",
         {"g(\\mathbf q) = 2 \\mathbf q", "a = g(2)"},
         "?",
         {"E4003 [2] 1st argument of `g`: expected ℝ³, got ℝ"}},
        {"of a colour for what is bold", {"g(\\mathbf q) = 2 \\mathbf q", "c = (1, 0, 0)^2", "a = g(c)"}, "RGB", {}},
        {"not of a vector for an angle of the convention",
         {"g(\\theta_i) = 2 \\theta_i", "a = g(\\vec{n})"},
         "?",
         {"E4003 [\\vec{n}] 1st argument of `g`: expected ℝ, got ℝ³"}},
        {"beside an angle of the convention", {"g(\\theta_i, x) = \\theta_i x", "a = g(2, \\vec{n})"}, "ℝ³", {}},
        {"not where an angle of the parameter is used",
         {"g(q) = \\cos\\theta_q", "a = g(2)"},
         "?",
         {"E4003 [2] 1st argument of `g`: expected ℝ³, got ℝ"}},
        {"nothing is said beside what is unknown", {"p = q", "g(x, y) = x \\cdot y", "a = g(p, \\vec{n})"}, "?", {}},
        {"too few arguments",
         {"g(x, y) = x \\cdot y", "a = g(\\vec{n})"},
         "?",
         {"E4004 [g(\\vec{n})] `g` takes 2 arguments, got 1"}},
        {"the derivative is of numbers", {"g(x) = 2x", "a = g'(3) + |g(\\vec{n})|"}, "ℝ", {}},
    }));

std::vector<std::string> chain(int length) {
  std::vector<std::string> equations = {"p_0(x) = 2x"};
  for (int i = 1; i < length; ++i) {
    equations.push_back("p_{" + std::to_string(i) + "}(x) = p_{" + std::to_string(i - 1) + "}(x)");
  }
  equations.push_back("a = p_{" + std::to_string(length - 1) + "}(\\vec{n})");
  return equations;
}

TEST(InstanceFacts, OneCallNeedsSoManyBodiesAtMost) {
  EXPECT_EQ(test::CheckedText(chain(100)).reports(), std::vector<std::string>{});
  const test::CheckedText text(chain(101));
  ASSERT_EQ(text.reports().size(), 1u);
  EXPECT_TRUE(text.reports()[0].starts_with("E3043 [p_{100}]")) << text.reports()[0];
}

TEST(InstanceFacts, WhatIsTooLargeDoesNotDependOnWhatWasAskedBefore) {
  std::vector<std::string> equations = chain(101);
  equations.back() = "b = p_{60}(\\vec{n})";
  equations.push_back("a = p_{100}(\\vec{n})");
  EXPECT_EQ(test::CheckedText(equations).reports().size(), 1u);
}

/// Each function calls the one before twice, with the arguments in another order.
TEST(InstanceFacts, APuzzleOfManyInstancesIsGivenUp) {
  std::string names = "x_1";
  for (int i = 2; i <= 20; ++i) names += ", x_{" + std::to_string(i) + "}";
  const std::string turned = names.substr(names.find(", ") + 2) + ", x_1";
  const std::string swapped = "x_{2}, x_1" + names.substr(std::string("x_1, x_{2}").size());
  std::vector<std::string> equations = {"p_0(" + names + ") = x_1"};
  for (int i = 1; i < 40; ++i) {
    const std::string before = "p_{" + std::to_string(i - 1) + "}";
    equations.push_back("p_{" + std::to_string(i) + "}(" + names + ") = " + before + "(" + turned + ") + 0 * " +
                        before + "(" + swapped + ")");
  }
  std::string arguments = "\\vec{n}";
  for (int i = 2; i <= 20; ++i) arguments += i % 2 == 0 ? ", 1" : ", \\vec{n}";
  equations.push_back("a = p_{39}(" + arguments + ")");
  EXPECT_EQ(test::CheckedText(equations).reports().size(), 1u);
}

}  // namespace
}  // namespace texbrdf
