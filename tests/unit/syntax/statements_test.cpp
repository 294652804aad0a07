// What is read of a display with several equations.

#include <gtest/gtest.h>

#include <string>

#include "diagnostics/diagnostic.h"
#include "support/parse_equation.h"
#include "syntax/print_source.h"

namespace texbrdf {
namespace {

/// The definitions as they are printed, then the codes of what was reported.
std::string read(std::string_view document) {
  const ParsedBlock block = test::parse_first_block(document);
  std::string text;
  for (const DefinitionSyntax& definition : block.definitions) {
    text += (text.empty() ? "" : " | ") + (definition.readable ? print_source(block, definition) : "?");
  }
  for (const Diagnostic& diagnostic : block.diagnostics) {
    text += " " + code_name(diagnostic.code) + "/" + std::string(severity_name(diagnostic.severity));
  }
  return text;
}

struct Case {
  const char* content;
  const char* read;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.content;
}

class Align : public testing::TestWithParam<Case> {};

TEST_P(Align, is_split) {
  EXPECT_EQ(read("\\begin{align}" + std::string(GetParam().content) + "\\end{align}"), GetParam().read);
}

constexpr Case kRows[] = {
    {"a &= 1 \\\\ b &= 2", "a=1 | b=2"},
    {"a &= 1, \\\\[2pt] b &= 2. \\label{eq:b} \\\\", "a=1 | b=2"},
    {"a &= 1 \\notag \\\\ &\\quad + 2 \\\\ b &= 3", "a=(1+2) | b=3"},
    {"a &= \\left( 1 \\right. \\\\ &\\left. + 2 \\right) \\\\ b &= 3", "a=(1+2) | b=3"},
    {"a &= \\left( 1 \\\\ b &= 2", "? | b=2 E2003/error"},
    {"a &= 1 + \\\\ b &= 2", "? | b=2 E2001/error"},
    {"a &= 1) \\\\ b &= 2", "? | b=2 E2004/error"},
    {"a &= \\frac{1}{2 \\\\ b &= \\frac{1}{2}", "? | b=(1/2) E2003/error"},
    {"a &=& 1 \\\\ && * 2", "a=(1*2)"},
    {"a &= 1 \\\\ &= 2 \\\\ b &= 3", "a=1 | b=3"},
    {"a &= 1, & b &= 2 \\\\ c &= 3", "a=1 | b=2 | c=3"},
    {"f(x) &= 1 \\\\ g(x) &= 2", "f(x)=1 | g(x)=2"},
};
INSTANTIATE_TEST_SUITE_P(Rows, Align, testing::ValuesIn(kRows));

constexpr Case kDisplays[] = {
    {"a = 1, \\quad b = 2", "a=1 | b=2"},
    {"a = 1; b = 2", "a=1 | b=2"},
    {"a = b \\qquad (12)", "a=b"},
    {"a = b, \\quad (12)", "a=b"},
    {"a = \\quad (12)", "a=12"},
    {"a = b\\,(12)", "a=b(12)"},
    {"a = 1. b = 2.", "a=1 | b=2"},
    {"a = 1 \\qquad b = 2", "a=1 | b=2"},
    {"a = 1 \\quad + 2", "a=(1+2)"},
    {"a = b \\text{ where } b = 2", "a=b | b=2"},
    {"a = b \\text{ with } b = 2, c = 3 \\text{ and } d = 4", "a=b | b=2 | c=3 | d=4"},
    {"a = 1 \\text{ for all } x", "a=1"},
    {"a = 1, \\quad x > 0", "a=1"},
    {"a = 1 \\text{ if } x = 0", "a=1 | x=0"},
    {"a_{\\text{in}} = 1", "a_{\\text{in}}=1"},
    {"a_\\text{in} = 1", "a_\\text{in}=1"},
    {"a = b = c", "a=b"},
    {"a = b = c, d = e", "a=b | d=e"},
    {"a \\approx 1", "a=1"},
    {"a := 1", "a=1"},
    {"0 \\le a \\le 1, b = 2", "b=2"},
    {"a \\propto b", ""},
    {"a b", " E2008/error"},
    {"a = (1, 2", "? E2003/error"},
    {"\\cos x = 1", "x=\\arccos(1)"},
    {"1 + 2 = f", " E2007/error"},
    {"a = [1 + \\{2 + 3\\}] 4", "a=((1+(2+3))*4)"},
    {"a = 1, 2", "? E2002/error"},
    {"a = b \\\\ |x|^2 = c", "a=b E2007/hint"},
};
INSTANTIATE_TEST_SUITE_P(Displays, Align, testing::ValuesIn(kDisplays));

constexpr Case kNotation[] = {
    {"a = |x|", "a=|x|"},
    {"a = |x||y| + ||x||", "a=((|x|*|y|)+|x|)"},
    {"a = \\|x\\| \\lVert y \\rVert \\left|z\\right|", "a=((|x|*|y|)*|z|)"},
    {"a = |b(|x| + 1)|", "a=|b((|x|+1))|"},
    {"a = |(|x|)|", "a=|(|x|)|"},
    {"a = 2|x|^2", "a=(2*(|x|^2))"},
    {"a = \\cos|x|", "a=\\cos(|x|)"},
    {"a = |x", "? E2003/error"},
    {"a = |x|)", "? E2004/error"},
    {"a = \\|x|", "? E2001/error"},
    {"a = \\langle x \\cdot y \\rangle^2 \\left<x, y\\right>", "a=((\\langle(x*y)\\rangle^2)*\\langle x,y\\rangle)"},
    {"a = \\langle x, y, z \\rangle", "? E2002/error"},
    {"a = \\langle x", "? E2003/error"},
    {"a = {k+1 \\over 2\\pi} b", "a=(((k+1)/(2*\\pi))*b)"},
    {"a = \\frac12 \\frac\\rho\\pi \\tfrac1{2} \\dfrac{1}2 \\frac x y",
     "a=(((((1/2)*(\\rho/\\pi))*(1/2))*(1/2))*(x/y))"},
    {"a = \\frac ab + \\frac1nx + \\frac h2", "a=(((a/b)+((1/n)*x))+(h/2))"},
    {"a = \\frac abc", "? E2016/error"},
    {"a = {} + b {} \\times c", "a=((+b)\\times c)"},
    {"\\boxed{a = \\frac{1}{2}}", "a=(1/2)"},
    {"a = 2\\boxed{b + c}d", "a=((2*(b+c))*d)"},
    {"a = \\left| b \\left| c \\right| d \\right|", "a=|((b*|c|)*d)|"},
    {"a = \\left| b - \\left| c \\right| \\right|", "a=|(b-|c|)|"},
    {"a = \\lvert\\lvert b \\rvert - \\bigl| c \\bigr| \\rvert", "a=|(|b|-|c|)|"},
    {"a = |b|/2|c|2", "a=(((|b|/2)*|c|)*2) E2019/information"},
    {"a = 2 \\quad [3]", "a=(2*3)"},
    {"a = 2 \\quad 3", "? E3012/error"},
    {"a = 3: \\\\ b = 2", "a=3 | b=2"},
    {"a = 2 + x \\\\ \\le 3", "a=(2+x)"},
    {"a = b & \\text{(specular)}", "a=b"},
    {"a = \\Bigl[ b \\Bigr]", "a=b"},
    {"a = \\exp[b] \\max\\{1, 2\\}", "a=(\\exp(b)*\\max(1,2))"},
};
INSTANTIATE_TEST_SUITE_P(Notation, Align, testing::ValuesIn(kNotation));

TEST(InlineMathematics, defines_or_is_prose) {
  EXPECT_EQ(read("$a = 0.5$"), "a=0.5");
  EXPECT_EQ(read("$g(s,u) = s u$"), "g(s,u)=(s*u)");
  EXPECT_EQ(read("$a = 1$"), "a=1");
  EXPECT_EQ(read("$a = 1, b = 2$"), "a=1 | b=2");
  for (const char* prose : {"$a = $", "$a = 1 + $", "$= 1$", "$|a| = 2$", "$i = 1, \\dots, n$", "$a = )$",
                            "$a_b_c = 1$", "$\\cos x = 1$", "$1 = f$"}) {
    EXPECT_EQ(read(prose), "") << prose;
  }
}

TEST(Displays, without_environments_are_read) {
  EXPECT_EQ(read("$$a = 1$$"), "a=1");
  EXPECT_EQ(read("\\[a = 1\\]"), "a=1");
  EXPECT_EQ(read("$$\\begin{align}a &= 1 \\\\ b &= 2\\end{align}$$"), "a=1 | b=2");
  EXPECT_EQ(read("\\begin{equation}\\begin{split}a &= 1 \\\\ &+ 2\\end{split}\\end{equation}"), "a=(1+2)");
  EXPECT_EQ(read("\\begin{alignat}{2}a &= 1 & b &= 2\\end{alignat}"), "a=1 | b=2");
  EXPECT_EQ(read("\\[a = 1\n\nprose"), "a=1 E2005/error");
  EXPECT_EQ(read("$$a = 1$ prose"), "a=1 E2006/error");
  EXPECT_EQ(read("\\begin{gather}a & = 1\\end{gather}"), "a=1 E1003/warning");
}

}  // namespace
}  // namespace texbrdf
