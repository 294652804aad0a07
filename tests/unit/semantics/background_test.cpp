#include "semantics/background.h"

#include <gtest/gtest.h>

#include <string>

#include "support/parse_equation.h"

namespace texbrdf {
namespace {

bool is_background(const std::string& document) {
  const ParsedBlock block = test::parse_first_block(document);
  EXPECT_EQ(block.definitions.size(), 1u) << document;
  NameTable table;
  const BlockNames names = read_names(block, table);
  return is_background(block, block.definitions.at(0), names, table);
}

TEST(Background, IsWhatStatesSomethingElse) {
  for (const char* equation :
       {"f_r(l, v) = f_r(v, l)", "f_r(l, v) = f_r(l, v)", "f_r = \\frac{dL_o}{dE_i}",
        "f = \\frac{\\mathrm{d}L}{\\mathrm{d}E}", "f_r(l, v) = dL_o(v) / dE_i(l)",
        "f_r = \\frac{\\partial L}{\\partial E}", "\\cos\\theta_o = \\int_\\Omega G(\\omega) d\\omega",
        "L = \\int_\\Omega L_i d\\omega"}) {
    EXPECT_TRUE(is_background("\\[" + std::string(equation) + "\\]")) << equation;
  }
  EXPECT_TRUE(is_background("$\\theta_i = 0$"));
  EXPECT_TRUE(is_background("$\\theta_h = -1$"));
  EXPECT_TRUE(is_background("$\\text{dot}(r, v) \\approx \\cos(2 \\arccos(\\text{dot}(n, h)))$"));
}

TEST(Background, IsNoDefinition) {
  for (const char* equation :
       {"f_r(l, v) = g(v, l)", "f_r(l, v) = 2 f_r(v, l)", "f(x) = f(2)", "f = f", "D = \\frac{D_0}{d}", "a = d / 2",
        "G = \\frac{d + 1}{d + 2}", "a = \\frac{d}{d}", "\\theta_i = 0", "\\cos\\theta_h = n \\cdot h",
        "\\text{sign}(x) = \\frac{x}{|x|}", "D(x) = D(2)", "g(x) = 2", "\\text{sign}(x) = 1",
        "E = \\int_\\Omega \\omega d\\omega", "E_{avg} = 2 \\int_0^1 E(x) x dx"}) {
    EXPECT_FALSE(is_background("\\[" + std::string(equation) + "\\]")) << equation;
  }
  for (const char* prose : {"$\\theta_i = \\theta_o$", "$\\alpha = 0$"}) EXPECT_FALSE(is_background(prose)) << prose;
}

}  // namespace
}  // namespace texbrdf
