#include "syntax/print_source.h"

#include <gtest/gtest.h>

#include "support/parse_equation.h"
#include "support/random.h"

namespace texbrdf {
namespace {

std::string printed(std::string_view equation) {
  const ParsedBlock block = test::parse_equation(equation);
  if (block.definitions.size() != 1 || !block.definitions[0].readable) return test::diagnostics_text(block);
  return print_source(block, block.definitions[0]);
}

struct Case {
  const char* equation;
  const char* printed;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.equation;
}

class PrintSource : public testing::TestWithParam<Case> {};

TEST_P(PrintSource, puts_all_operations_in_parentheses) {
  EXPECT_EQ(printed(GetParam().equation), GetParam().printed);
}

TEST_P(PrintSource, prints_what_parses_to_the_same) {
  EXPECT_EQ(printed(GetParam().printed), GetParam().printed);
}

constexpr Case kDocumented[] = {
    {"a = 1+2", "a=(1+2)"},       {"a = \\exp 1 + 2^3", "a=(\\exp(1)+(2^3))"},
    {"a = -2^2", "a=(-(2^2))"},   {"a = 2^3^2", "a=(2^(3^2))"},
    {"a = 1-2-3", "a=((1-2)-3)"}, {"a = a(1*2 ^ 4 + \\sqrt 4^8 , 2)", "a=a(((1*(2^4))+(\\sqrt(4)^8)),2)"},
};
INSTANTIATE_TEST_SUITE_P(Documented, PrintSource, testing::ValuesIn(kDocumented));

constexpr Case kPrecedence[] = {
    {"a = 1+2*3-4/5", "a=((1+(2*3))-(4/5))"},
    {"a = 1/2/3*4", "a=(((1/2)/3)*4)"},
    {"a = \\frac{1}23 + \\sqrt 42", "a=(((1/2)*3)+(\\sqrt(4)*2))"},
    {"a = \\frac{d^2}{dx^2} x^3", "a=(\\frac{d^2}{d x^2}((x^3)))"},
    {"a = \\frac{\\partial^3 g}{\\partial x\\partial y^2}", "a=(\\frac{d^2}{d y^2}((\\frac{d}{d x}(g))))"},
    {"a = \\frac{\\partial^2}{\\partial x\\partial y} g", "a=(\\frac{d}{d x}((\\frac{d}{d y}(g))))"},
    {"\\langle E_F\\rangle = b", "\\langle E_F\\rangle=b"},
    {"a = a\\cdot b*c", "a=((a*b)*c)"},
    {"a = a\\times b\\times c", "a=((a\\times b)\\times c)"},
    {"a = \\alpha\\times\\beta", "a=(\\alpha\\times\\beta)"},
    {"a = -a*b", "a=((-a)*b)"},
    {"a = a*-b", "a=(a*(-b))"},
    {"a = a - -b", "a=(a-(-b))"},
    {"a = +-b", "a=(+(-b))"},
    {"a = 2^-2", "a=(2^(-2))"},
    {"a = 2^-2*3", "a=((2^(-2))*3)"},
    {"a = 2^-x^2", "a=(2^(-(x^2)))"},
    {"a = x^{-4}", "a=(x^(-4))"},
    {"a = x^{(k-1)}", "a=(x^(k-1))"},
    {"a = x^\\text{name}", "a=(x^\\text{name})"},
    {"a = {1+2}*3", "a=((1+2)*3)"},
    {"a = (1, -b + 2, c)^2(d, e)", "a=(((1,((-b)+2),c)^2)*(d,e))"},
    {"a = \\frac{a}{b}^2", "a=((a/b)^2)"},
    {"a = \\frac{1+2}{3}", "a=((1+2)/3)"},
    {"a = \\sqrt[n]{x}", "a=\\sqrt[n](x)"},
    {"a = \\sqrt[n+1]{x}^2", "a=(\\sqrt[(n+1)](x)^2)"},
    {"a = \\sqrt(x)", "a=\\sqrt(x)"},
    {"a = \\sqrt -2", "a=\\sqrt((-2))"},
    {"a = \\max{1,2, 3}", "a=\\max(1,2,3)"},
};
INSTANTIATE_TEST_SUITE_P(Precedence, PrintSource, testing::ValuesIn(kPrecedence));

constexpr Case kFunctions[] = {
    {"a = \\cos{\\theta_h}^n", "a=(\\cos(\\theta_h)^n)"},
    {"a = \\cos(x)^2", "a=(\\cos(x)^2)"},
    {"a = \\cos\\left(x\\right)^2", "a=(\\cos(x)^2)"},
    {"a = \\ln\\alpha^2", "a=\\ln((\\alpha^2))"},
    {"a = \\exp -2^2", "a=\\exp((-(2^2)))"},
    {"a = \\exp -(x)^2", "a=\\exp((-(x^2)))"},
    {"a = \\sin\\cos x", "a=\\sin(\\cos(x))"},
    {"a = \\sin\\cos x^2", "a=\\sin(\\cos((x^2)))"},
    {"a = \\sin f(x)", "a=\\sin(f(x))"},
    {"a = \\sin f(x)^2", "a=\\sin((f(x)^2))"},
    {"a = \\sin\\frac{1}{2}", "a=\\sin((1/2))"},
    {"a = \\sin\\max(1,2)*3", "a=(\\sin(\\max(1,2))*3)"},
    {"a = \\sin x*y", "a=(\\sin(x)*y)"},
    {"a = \\sin\\vec{1,2,3}", "a=\\sin(\\vec{1,2,3})"},
    {"a = \\exp 2^3^2", "a=\\exp((2^(3^2)))"},
    {"a = 2^\\sin x", "a=(2^\\sin(x))"},
};
INSTANTIATE_TEST_SUITE_P(Functions, PrintSource, testing::ValuesIn(kFunctions));

constexpr Case kLeftSides[] = {
    {"\\cos\\xi = x", "\\xi=\\arccos(x)"},
    {"\\cos\\theta_{d} = L\\cdot H", "\\theta_{d}=\\arccos((L*H))"},
    {"\\sin(\\mathbf{t}') = 1/n", "\\mathbf{t}'=\\arcsin((1/n))"},
    {"\\tan{t_{i_1}} &= a+b", "t_{i_1}=\\arctan((a+b))"},
    {"{f} = 1", "f=1"},
    {"{\\color{blue} F(x)} = x", "F(x)=x"},
    {"{{\\cos\\xi}} = x", "\\xi=\\arccos(x)"},
    {"{\\bf n}(x) = x", "{\\bf n}(x)=x"},
    {"h_r = h_r(i, o) = i", "h_r=i"},
    {"g(x) = g = x = 2", "g(x)=x"},
    {"g(x) = h = x", "g(x)=h"},
    {"F(\\cos\\theta) = 1-\\cos\\theta", "F(\\cos(\\theta))=(1-\\cos(\\theta))"},
    {"F(v\\cdot h, x) = v\\cdot h", "F((v*h),x)=(v*h)"},
    {"f_r^{(1)}(x) = f_r^{(2)}(x)", "f_r^{(1)}(x)=f_r^{(2)}(x)"},
    {"a = x^{(2)}", "a=(x^2)"},
    {"a = F_LF_V", "a=(F_L*F_V)"},
    {"a = F_LxyF_V^2", "a=((F_L*xy)*(F_V^2))"},
    {"a = x_ab", "a=x_ab"},
};
INSTANTIATE_TEST_SUITE_P(LeftSides, PrintSource, testing::ValuesIn(kLeftSides));

constexpr Case kNames[] = {
    {"\\rho_d(m, \\omega_i) = \\rho_d (1 , 2)", "\\rho_d(m,\\omega_i)=\\rho_d(1,2)"},
    {"\\text{cook\\_torrance} = x_{n + 1}", "\\text{cook\\_torrance}=x_{n+1}"},
    {"a = \\phi_{\\text{diff}}+s_\\alpha", "a=(\\phi_{\\text{diff}}+s_\\alpha)"},
    {"a = f_{n_i}", "a=f_{n_i}"},
    {"a = x_{a_{b_{c}}}", "a=x_{a_{b_{c}}}"},
    {"a = x_{\\alpha b}", "a=x_{\\alpha b}"},
    {"a = x_{\\max}", "a=x_{\\max}"},
    {"a = x_\\max", "a=x_\\max"},
    {"a = x_\\vec{n}", "a=x_\\vec{n}"},
    {"a = x_{f(1),2}", "a=x_{f(1),2}"},
    {"a = \\vec{\\omega_i}", "a=\\vec{\\omega_i}"},
    {"a = \\vec{n}_1", "a=\\vec{n}_1"},
    {"a = \\vec n", "a=\\vec n"},
    {"\\vec{g}(\\vec{x}) = 1", "\\vec{g}(\\vec{x})=1"},
    {"a = \\vec{ 1, -0.5 , +.5}", "a=\\vec{1,-0.5,+.5}"},
    {"a &= 1", "a=1"},
};
INSTANTIATE_TEST_SUITE_P(Names, PrintSource, testing::ValuesIn(kNames));

constexpr Case kProducts[] = {
    {"a = 2x", "a=(2*x)"},
    {"a = 2x^2y", "a=((2*(x^2))*y)"},
    {"a = (1)(2)", "a=(1*2)"},
    {"a = 2(1+x)^2", "a=(2*((1+x)^2))"},
    {"a = \\foo{1}", "a=(\\foo*1)"},
    {"a = -2x", "a=((-2)*x)"},
    {"a = 1/2x", "a=((1/2)*x)"},
    {"a = x/yz w", "a=((x/yz)*w)"},
    {"a = \\frac{1}{2}x", "a=((1/2)*x)"},
    {"a = x\\sqrt 2y", "a=((x*\\sqrt(2))*y)"},
    {"a = \\cos x\\sin y", "a=(\\cos(x)*\\sin(y))"},
    {"a = \\cos 2x", "a=\\cos((2*x))"},
    {"a = \\cos n\\phi", "a=\\cos((n*\\phi))"},
    {"a = \\cos n\\phi^2", "a=\\cos((n*(\\phi^2)))"},
    {"a = \\cos x\\,y", "a=(\\cos(x)*y)"},
    {"a = \\cos x 2", "a=(\\cos(x)*2)"},
    {"a = \\cos x(y)", "a=\\cos(x(y))"},
    {"a = \\cos(x)y", "a=(\\cos(x)*y)"},
    {"a = \\exp -2x", "a=\\exp((-(2*x)))"},
    {"a = \\tan^2\\theta/m^2", "a=((\\tan(\\theta)^2)/(m^2))"},
    {"a = \\cos^2(x)", "a=(\\cos(x)^2)"},
    {"a = \\cos^{n+1} x y", "a=(\\cos((x*y))^(n+1))"},
    {"a = \\cos^n(x)", "a=(\\cos(x)^n)"},
    {"a = \\cos^n x", "a=(\\cos(x)^n)"},
    {"a = \\cos^{-1} x", "a=\\arccos(x)"},
    {"a = \\ln^{-1} x", "a=\\exp(x)"},
    {"a = \\cos^{-2} x", "a=(\\cos(x)^(-2))"},
};
INSTANTIATE_TEST_SUITE_P(Products, PrintSource, testing::ValuesIn(kProducts));

/// A random expression with all forms of the language.
class RandomExpression {
 public:
  explicit RandomExpression(uint64_t seed) : random_(seed) {}

  std::string make(int depth) {
    if (depth <= 0) return atom();
    const auto sub = [&] { return make(depth - 1 - static_cast<int>(random_.below(2))); };
    switch (random_.below(14)) {
      case 12:
        return "(" + sub() + ")(" + sub() + ")";
      case 13:
        return "\\cos^{" + sub() + "}x y";
      case 0:
        return sub() + "+" + sub();
      case 1:
        return sub() + " - " + sub();
      case 2:
        return sub() + "*" + sub();
      case 3:
        return sub() + "\\cdot " + sub();
      case 4:
        return sub() + "/" + sub();
      case 5:
        return sub() + "^" + sub();
      case 6:
        return "-" + sub();
      case 7:
        return "\\frac{" + sub() + "}{" + sub() + "}";
      case 8:
        return "\\left(" + sub() + "\\right)";
      case 9:
        return random_.chance(0.5) ? "\\exp " + sub() : "\\sqrt[" + sub() + "]{" + sub() + "}";
      case 10:
        return "\\max(" + sub() + "," + sub() + ")";
      default:
        return "g(" + sub() + ", " + sub() + ")";
    }
  }

 private:
  std::string atom() {
    static const std::vector<std::string> kAtoms = {"1",        ".5",      "2e-3", "x",         "\\alpha",
                                                    "\\vec{n}", "x_{n+1}", "uH",   "\\text{a}", "\\vec{1,-2,3}"};
    return random_.one_of(kAtoms);
  }

  test::Random random_;
};

/// The tree without groups: `(Infix 1 2)` …
std::string shape(const ParsedBlock& block, NodeId id) {
  const Node& node = block.tree.node(id);
  if (node.kind == NodeKind::Group) return shape(block, block.tree.child(id, 0));
  std::string text = "(";
  if (node.kind == NodeKind::Fraction) {
    text += "Infix /";
  } else if (node.kind == NodeKind::Juxtaposition) {
    text += "Infix *";
  } else if (node.kind == NodeKind::Inverse) {
    text += "Function";
  } else {
    text += node_kind_name(node.kind);
  }
  if (node.kind == NodeKind::Infix) {
    text +=
        block.tokens[node.token].kind == TokenKind::Multiply ? " *" : " " + std::string(block.token_text(node.token));
  }
  for (const NodeId child : block.tree.children(id)) text += " " + shape(block, child);
  return text + (node.child_count == 0 ? " " + std::string(block.node_text(id)) : "") + ")";
}

TEST(PrintSourceRandom, parses_back_to_the_same_tree) {
  RandomExpression expressions(42);
  for (int round = 0; round < 3000; ++round) {
    const std::string equation = "f = " + expressions.make(5);
    const ParsedBlock block = test::parse_equation(equation);
    ASSERT_EQ(block.definitions.size(), 1u) << equation;
    ASSERT_TRUE(block.definitions[0].readable) << equation << test::diagnostics_text(block);
    const std::string print = print_source(block, block.definitions[0]);
    const ParsedBlock again = test::parse_equation(print);
    ASSERT_EQ(again.definitions.size(), 1u) << print;
    EXPECT_TRUE(again.diagnostics.empty()) << equation << "\n" << print << "\n" << test::diagnostics_text(again);
    EXPECT_EQ(shape(again, again.definitions[0].node), shape(block, block.definitions[0].node)) << equation << "\n"
                                                                                                << print;
    EXPECT_EQ(print_source(again, again.definitions[0]), print);
  }
}

}  // namespace
}  // namespace texbrdf
