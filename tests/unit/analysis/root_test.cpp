#include <gtest/gtest.h>

#include "reports.h"

namespace texbrdf {
namespace {

using test::equations;

struct Case {
  const char* what;
  std::string document;
  std::string root;
  bool is_ours = true;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.what;
}

class Root : public testing::TestWithParam<Case> {};

TEST_P(Root, IsChosen) {
  Document document(GetParam().document);
  EXPECT_EQ(document.snapshot().root_name(), GetParam().root);
  EXPECT_EQ(document.snapshot().is_ours(), GetParam().is_ours);
}

INSTANTIATE_TEST_SUITE_P(
    Documents, Root,
    testing::ValuesIn(std::vector<Case>{
        {"f, though it is constant", equations({"f = 1"}), "f"},
        {"f of two vectors", equations({"f(\\vec{a}, \\vec{b}) = 1", "f_r = 1"}), "f"},
        {"the one that depends on a direction", equations({"f = 1", "f_r = \\theta_h"}), "f_r"},
        {"through another definition", equations({"f = 1", "a = \\theta_h", "f_{spec} = a"}), "f_{spec}"},
        {"the one that no other uses", equations({"f_d = \\theta_i", "f_s = \\theta_o", "f_r = f_d + f_s"}), "f_r"},
        {"not even from afar", equations({"f_s = \\theta_o", "f_a = \\theta_i", "g = f_s", "f_t = g + \\theta_i"}),
         "f_t"},
        {"no function of two numbers", equations({"f = \\theta_h", "a = \\theta_i", "f_n(x, y) = a * x * y"}), "f"},
        {"of two equals f itself", equations({"f_r = \\theta_o", "f = \\theta_i"}), "f"},
        {"of two equals the first", equations({"f_x = \\theta_o", "f_a = \\theta_i"}), "f_x"},
        {"a function \\rho of two directions", equations({"\\rho(\\vec{a}, \\vec{b}) = \\rho_d", "\\rho_d = 1"}),
         "\\rho"},
        {"f before \\rho", equations({"\\rho(\\vec{a}, \\vec{b}) = 1", "f_r = \\theta_h"}), "f_r"},
        {"\\rho is an albedo", equations({"\\rho = 1", "\\rho_d(x) = x"}), "f", false},
        {"none", equations({"a = \\theta_h", "g(x) = x"}), "f", false},
        {"no equations", "prose", "f", false},
        {"an instruction", "% texbrdf: root = D\n\n" + equations({"D = \\theta_h", "f = D"}), "D"},
        {"an instruction without sign and far below", equations({"D = \\theta_h", "f = D"}) + "%texbrdf: root D\n",
         "D"},
        {"an instruction above an equation", "% texbrdf: root = D\n" + equations({"D = \\theta_h", "f = D"}), "D"},
        {"another spelling", "% texbrdf: root = x_{1}\n\n" + equations({"x_1 = \\theta_h", "f = 1"}), "x_1"},
        {"an instruction for what is not there", "% texbrdf: root = D\n\n" + equations({"f = 1"}), "D"},
        {"any instruction makes a document one of ours", "% texbrdf: allow E3013\n\n" + equations({"a = 1"}), "f"},
        {"an instruction in verbatim text is none",
         "\\begin{verbatim}\n% texbrdf: root = D\n\\end{verbatim}\n" + equations({"f = 1"}), "f"},
    }));

std::vector<std::string> codes(const std::string& text) {
  Document document(text);
  std::vector<std::string> found;
  for (const Diagnostic& diagnostic : document.snapshot().diagnostics()) {
    found.push_back(code_name(diagnostic.code) + " " + std::string(severity_name(diagnostic.severity)));
  }
  return found;
}

using Codes = std::vector<std::string>;

TEST(RootDiagnostics, ErrorsThatTheRootDoesNotNeedAreHints) {
  EXPECT_EQ(codes(equations({"a = q", "b = a", "f = 1"})), (Codes{"E3001 hint", "E3013 hint"}));
  EXPECT_EQ(codes(equations({"a = q", "b = a", "f = b"})), (Codes{"E3001 error"}));
  EXPECT_EQ(codes(equations({"a = b", "b = a", "f = 1"})), (Codes{"E3009 hint"}));
  EXPECT_EQ(codes(equations({"a = 1", "a = 2", "f = 1"})), (Codes{"E3013 hint", "E3006 hint"}));
  EXPECT_EQ(codes(equations({"a = (1", "f = 1"})), (Codes{"E3013 hint", "E2003 hint"})) << "it cannot be read";
}

TEST(RootDiagnostics, ABrdfOfOtherThanTwoVectorsIsGivenWhatItsParametersAreCalled) {
  for (const char* left : {"f(\\theta_i, \\phi_i; \\theta_o, \\phi_o)", "f(\\theta_h)",
                           "f(\\vec{x}, \\omega_i, \\omega_o)", "f(\\omega_i)", "f(\\theta_i; \\sigma)"}) {
    const std::string text = equations({std::string(left) + " = \\sigma \\cdot 2", "\\sigma = 0.5"});
    EXPECT_TRUE(Document(text).snapshot().program()) << text;
  }
  for (const char* left : {"f(x)", "f(\\theta_i, q)", "f(\\sigma)", "f(g)"}) {
    const std::string text = equations({std::string(left) + " = 2", "\\sigma = \\vec{1, 2, 3}", "g(x) = x"});
    EXPECT_FALSE(Document(text).snapshot().program()) << text;
    const Codes found = codes(text);
    EXPECT_NE(std::ranges::find(found, "E4006 error"), found.end()) << text;
  }
}

TEST(RootDiagnostics, WhatTheParametersOfABrdfAreCalledIsNeeded) {
  EXPECT_EQ(codes(equations({"f(\\theta_i, \\sigma) = \\sigma \\theta_i", "\\sigma = 0.3"})), Codes{});
  EXPECT_EQ(codes(equations({"f(\\theta_i, \\sigma) = \\sigma \\theta_i", "\\sigma = 0.3 + a", "a = 2 q"})),
            (Codes{"E3001 error"}));
}

TEST(RootDiagnostics, AnInstructionSkipsAnEquation) {
  EXPECT_EQ(codes("% texbrdf: ignore\n" + equations({"a = (1", "f = 1"})), Codes{});
  EXPECT_EQ(codes("% texbrdf: ignore\n% why\n  " + equations({"a = (1", "f = 1"})), Codes{});
  EXPECT_EQ(codes("% texbrdf: ignore\n\n" + equations({"a = @", "f = 1"})), (Codes{"E3013 hint", "E1001 hint"}))
      << "a blank line stands between";
}

TEST(RootDiagnostics, AnInstructionSilencesACode) {
  EXPECT_EQ(codes(equations({"f = q + r"})), (Codes{"E3001 error", "E3001 error"}));
  EXPECT_EQ(codes("% texbrdf: allow E3001\n" + equations({"f = q", "a = q"})), (Codes{"E3013 hint", "E3001 hint"}));
  EXPECT_EQ(codes("% texbrdf: allow E3001\n\n" + equations({"f = q", "a = q"})), (Codes{"E3013 hint"}));
}

TEST(RootDiagnostics, AnInstructionThatAsksForNothingIsTold) {
  EXPECT_EQ(codes(equations({"f = 1"}) + "% texbrdf: rot = f\n"), (Codes{"E0001 warning"}));
  EXPECT_EQ(codes("% texbrdf: allow\n" + equations({"f = 1"})), (Codes{"E0001 warning"}));
  EXPECT_EQ(codes("% texbrdf: ignore this\n" + equations({"f = 1"})), (Codes{"E0001 warning"}));
}

}  // namespace
}  // namespace texbrdf
