// What is read of cases, conditions and columns, and what is reported.

#include <gtest/gtest.h>

#include <string>

#include "support/parse_equation.h"
#include "syntax/print_source.h"

namespace texbrdf {
namespace {

/// The definitions as they are printed, then what was reported.
std::string read(const ParsedBlock& block) {
  std::string text;
  for (const DefinitionSyntax& definition : block.definitions) {
    text += (text.empty() ? "" : " | ") + (definition.readable ? print_source(block, definition) : "?");
  }
  const std::string problems = test::diagnostics_text(block);
  return problems.empty() ? text : text + " " + problems;
}

struct Case {
  const char* equation;
  const char* read;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.equation;
}

class Rows : public testing::TestWithParam<Case> {};

TEST_P(Rows, AreRead) {
  EXPECT_EQ(read(test::parse_equation(GetParam().equation)), GetParam().read);
}

/// All these are one thing.
#define STEP(equation) Case{equation, "a=\\begin{cases}1&(x>0)\\\\0&\\text{otherwise}\\end{cases}"}

constexpr Case kSpellings[] = {
    STEP("a = \\begin{cases} 1 & x > 0 \\\\ 0 & \\text{otherwise} \\end{cases}"),
    STEP("a = \\begin{cases} 1 & x > 0 \\\\ 0 \\end{cases}"),
    STEP("a = \\begin{cases} 1, & \\text{if } x > 0, \\\\[2pt] 0, & \\text{otherwise.} \\\\ \\end{cases}"),
    STEP("a = \\begin{dcases*} 1 & \\text{for}\\ x > 0 \\\\ 0 & \\text{ else } \\end{dcases*}"),
    STEP("a = \\begin{cases} 1 & \\text{if $x>0$,} \\\\ 0 & \\mathrm{else} \\end{cases}."),
    STEP("a = \\begin{cases} 1 \\quad \\text{when} \\quad x > 0 \\\\ 0 \\quad \\text{in all other cases} \\end{cases}"),
    STEP("a = \\begin{cases} 1 \\text{ if } x > 0 \\\\ 0 \\text{ otherwise} \\end{cases}"),
    STEP("a = \\begin{cases} 1, x > 0 \\\\ 0, \\mbox{otherwise} \\end{cases}"),
    STEP("a = \\begin{cases} 1 & \\text{where} & x > 0 \\\\ 0 & & {\\rm otherwise} \\end{cases}"),
    STEP("a = \\begin{cases} 1 & if x > 0 \\\\ 0 & otherwise \\end{cases}"),
    STEP("a = \\begin{dcases*} 1 & if $x > 0$, \\\\ 0 & otherwise \\end{dcases*}"),
    STEP("a = \\begin{cases} 1 & x > 0 \\text{ (in front)} \\\\ 0 & \\text{(otherwise)} \\end{cases}"),
    STEP("a = \\left\\{ \\begin{array}{ll} 1 & x > 0 \\\\ 0 & \\text{otherwise} \\end{array} \\right."),
    STEP("a = \\left\\lbrace\\begin{matrix} 1 & x > 0 \\\\ 0 & \\text{otherwise} \\end{matrix}\\right."),
    STEP("a = \\Bigl\\{\\begin{aligned} &1 && x > 0 \\\\ &0 && \\text{otherwise} \\end{aligned}"),
    {"a = \\begin{cases} 0 & \\text{otherwise} \\\\ 1 & x > 0 \\end{cases}",
     "a=\\begin{cases}0&\\text{otherwise}\\\\1&(x>0)\\end{cases}"},
    {"a = 2\\begin{cases} 1 & x > 0 \\\\ 0 & x \\le 0 \\end{cases} + 1",
     "a=((2*\\begin{cases}1&(x>0)\\\\0&(x\\le0)\\end{cases})+1)"},
    {"a = \\begin{cases} \\begin{cases} 1 & y > 0 \\\\ 2 \\end{cases} & x > 0 \\\\ \\frac12 & 0 \\geq x \\end{cases}",
     "a=\\begin{cases}\\begin{cases}1&(y>0)\\\\2&\\text{otherwise}\\end{cases}&(x>0)\\\\(1/2)&(0\\geq x)\\end{cases}"},
};
INSTANTIATE_TEST_SUITE_P(Spellings, Rows, testing::ValuesIn(kSpellings));

#define WHERE(condition) "a = \\begin{cases} 1 & " condition " \\\\ 0 & \\text{else} \\end{cases}"
#define READ_WHERE(condition) "a=\\begin{cases}1&" condition "\\\\0&\\text{otherwise}\\end{cases}"

constexpr Case kConditions[] = {
    {WHERE("0 < x \\le 1"), READ_WHERE("(0<x\\le1)")},
    {WHERE("x > 0 \\land y > 0 \\lor z = 0"), READ_WHERE("(((x>0)\\land(y>0))\\lor(z=0))")},
    {WHERE("x > 0 \\wedge (y \\ne 0 \\vee z \\neq 1)"), READ_WHERE("((x>0)\\land((y\\ne0)\\lor(z\\neq1)))")},
    {WHERE("\\text{if } x > 0 \\text{ and } y > 0"), READ_WHERE("((x>0)\\land(y>0))")},
    {WHERE("\\text{if $x > 0$ or $y > 0$}"), READ_WHERE("((x>0)\\lor(y>0))")},
    {WHERE("x > 0, y > 0"), READ_WHERE("((x>0)\\land(y>0))")},
    {WHERE("\\neg (x > 0)"), READ_WHERE("(\\neg(x>0))")},
    {WHERE("(x + 1) > 0"), READ_WHERE("((x+1)>0)")},
    {WHERE("\\max(x, y) > 0"), READ_WHERE("(\\max(x,y)>0)")},
    {WHERE("|x| < 1"), READ_WHERE("(|x|<1)")},
    {WHERE("x \\in [0, 1]"), READ_WHERE("(x\\in[0,1])")},
    {WHERE("x \\in (0, 1]"), READ_WHERE("(x\\in(0,1])")},
    {WHERE("x \\in [0, 1) \\land y > 0"), READ_WHERE("((x\\in[0,1))\\land(y>0))")},
};
INSTANTIATE_TEST_SUITE_P(Conditions, Rows, testing::ValuesIn(kConditions));

constexpr Case kColumns[] = {
    {"a = \\begin{pmatrix} 1 \\\\ x^2 \\\\ 3 \\end{pmatrix}", "a=(1,(x^2),3)"},
    {"a = \\begin{bmatrix} 1 & 2 & 3 \\end{bmatrix}", "a=(1,2,3)"},
    {"a = \\left( \\begin{array}{c} 1 \\\\ 2 \\\\ 3 \\\\ \\end{array} \\right)", "a=(1,2,3)"},
    {"a = \\begin{pmatrix} 1 & 2 & 3 \\end{pmatrix}^T + (1, 2, 3)^{\\top}", "a=((1,2,3)+(1,2,3))"},
    {"a = (1, 2, 3)^T", "a=((1,2,3)^T)"},
    {"a = \\begin{pmatrix} 1 \\\\ 2 \\end{pmatrix} + (3, 4)^T", "a=((1,2)+((3,4)^T))"},
    {"a = \\begin{pmatrix} 1 & 2 \\end{pmatrix}^T", "a=(1,2)"},
    {"a = \\begin{pmatrix} 1 \\\\ 2 \\end{pmatrix}^T M", "a=(((1,2)^T)*M)"},
    {"a = \\begin{pmatrix} \\end{pmatrix}", "? E2001 [\\end{pmatrix}]"},
};
INSTANTIATE_TEST_SUITE_P(Columns, Rows, testing::ValuesIn(kColumns));

#define TWO_BY_TWO "\\begin{pmatrix}1&2\\\\3&4\\end{pmatrix}"

constexpr Case kMatrices[] = {
    {"a = \\begin{pmatrix} 1 & 2 \\\\ 3 & 4 \\\\ \\end{pmatrix}", "a=" TWO_BY_TWO},
    {"a = \\left[ \\begin{array}{cc} 1 & 2 \\\\ 3 & 4 \\end{array} \\right]^{-1}", "a=(" TWO_BY_TWO "^(-1))"},
    {"a = \\begin{vmatrix} 1 & 2 \\\\ 3 & 4 \\end{vmatrix}", "a=|" TWO_BY_TWO "|"},
    {"a = \\left| \\begin{matrix} 1 & 2 \\\\ 3 & 4 \\end{matrix} \\right|", "a=|" TWO_BY_TWO "|"},
    {"a = \\begin{bsmallmatrix} 1 & 2 \\\\ 3 & 4 \\end{bsmallmatrix} (5, 6)", "a=(" TWO_BY_TWO "*(5,6))"},
    {"a = \\det M^{-1} + \\det(M)", "a=(\\det((M^(-1)))+\\det(M)) E2013 [^]"},
    {"a = \\begin{pmatrix} 1 & 2 \\\\ 3 \\end{pmatrix}", "? E2035 [3]"},
    {"a = \\begin{pmatrix} 1 & 2 \\\\ 3 & 4 & 5 \\\\ 6 \\end{pmatrix}", "? E2035 [3 & 4 & 5]"},
    {"a = \\begin{pmatrix} 1 & \\\\ 3 & 4 \\end{pmatrix}", "? E2001 [\\\\]"},
    {"a = \\begin{pmatrix} 1 & 2 & 3 & 4 & 5 \\\\ 1 & 2 & 3 & 4 & 5 \\end{pmatrix}", "? E2032 [\\begin{pmatrix}]"},
};
INSTANTIATE_TEST_SUITE_P(Matrices, Rows, testing::ValuesIn(kMatrices));

constexpr Case kPluses[] = {
    {"a = (x)^+", "a=\\langle x\\rangle"},
    {"a = [x + 1]^{+} y", "a=(\\langle(x+1)\\rangle*y)"},
    {"a = (x)_+ + x^{+}", "a=(\\langle x\\rangle+\\langle x\\rangle)"},
    {"a = x^+", "a=\\langle x\\rangle"},
    {"a = x^+2", "a=(x^(+2))"},
    {"a = (x)^+2", "a=(x^(+2))"},
    {"a = \\chi^+(x) \\chi^{+}\\!\\left(y\\right)", "a=(\\chi^+(x)*\\chi^{+}(y))"},
    {"\\chi^+(x) = 1", "\\chi^+(x)=1"},
};
INSTANTIATE_TEST_SUITE_P(Pluses, Rows, testing::ValuesIn(kPluses));

constexpr Case kProblems[] = {
    {"a = \\begin{cases} \\end{cases}", "? E2001 [\\end{cases}]"},
    {"a = \\begin{cases} 1 & x > 0", "? E2003 [\\begin{cases}]"},
    {"a = 1 \\end{cases}", "a=1 E2006 [\\begin{equation}]"},
    {"\\begin{split} a = 1 \\end{cases}", "? E2004 [\\end{cases}]"},
    {"a = \\begin{cases} 1 & x > 0 \\\\ 0 & x \\le 0 \\end{array}", "? E2006 [\\begin{cases}]"},
    {"a = \\begin{cases} 1 & x > 0 \\\\ 0 & x \\le 0 \\end{case}", "? E2006 [\\begin{cases}]"},
    {"a = \\begin{cases} 1 & x > \\\\ & y > 0 \\\\ 3 \\end{cases}", "? E2001 [\\\\] E2001 [&]"},
    {"a = \\begin{cases} 1 x > 0 \\\\ 0 \\end{cases}", "? E2002 [>]"},
    {"a = \\begin{cases} 1 & x > 0 & y \\\\ 0 \\end{cases}", "? E2002 [y]"},
    {"a = \\begin{cases} (1 & x > 0 \\\\ 0 \\end{cases}", "? E2003 [(]"},
    {"a = \\begin{cases} 1 \\\\ 0 & x > 0 \\end{cases}", "? E2030 [1]"},
    {"a = \\begin{cases} 1 & \\text{else} \\\\ 0 \\end{cases}", "? E2030 [0]"},
    {"a = \\begin{cases} 1 & x > 0 \\\\ 0 & x < 0 \\end{cases}",
     "a=\\begin{cases}1&(x>0)\\\\0&(x<0)\\end{cases} E2031 [\\begin{cases}]"},
    {"a = 1 \\text{ if } x > 0", "a=1 E2033 [\\text{ if }]"},
    {"a = 1 \\text{ if $x > 0$}", "a=1 E2033 [\\text{ if $x > 0$}]"},
    {"a = 1 \\text{ for } b = 2", "a=1 | b=2"},
    {WHERE("x \\ll 1"), "? E2034 [\\ll]"},
    {WHERE("x \\in y"), "? E2034 [\\in]"},
    {WHERE("\\text{if $x$ is small}"), "? E2002 [ is small}]"},
};
INSTANTIATE_TEST_SUITE_P(Problems, Rows, testing::ValuesIn(kProblems));

TEST(Cases, AreRowsOfTheirOwnInADisplay) {
  EXPECT_EQ(read(test::parse_first_block("\\begin{align} a &= \\begin{cases} 1 & x > 0 \\\\ 2 & x \\le 0 \\end{cases} "
                                         "\\\\ b &= 3, & c &= 4 \\end{align}")),
            "a=\\begin{cases}1&(x>0)\\\\2&(x\\le0)\\end{cases} | b=3 | c=4");
}

TEST(Cases, WithoutAnEndLeaveTheRestOfADisplayAlone) {
  EXPECT_EQ(read(test::parse_first_block(
                "\\begin{align} a &= \\begin{cases} 1 & x > 0 \\\\ 2 & x \\le 0 \\\\ b &= 3 \\end{align}")),
            "? | b=3 E2003 [\\begin{cases}]");
}

}  // namespace
}  // namespace texbrdf
