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
  for (const char* equation : {"f_r(l, v) = f_r(v, l)", "f_r(l, v) = f_r(l, v)", "f_r = \\frac{dL_o}{dE_i}",
                               "f = \\frac{\\mathrm{d}L}{\\mathrm{d}E}", "f_r(l, v) = dL_o(v) / dE_i(l)",
                               "f_r = \\frac{\\partial L}{\\partial E}"}) {
    EXPECT_TRUE(is_background("\\[" + std::string(equation) + "\\]")) << equation;
  }
  EXPECT_TRUE(is_background("$\\theta_i = 0$"));
  EXPECT_TRUE(is_background("$\\theta_h = -1$"));
}

TEST(Background, IsNoDefinition) {
  for (const char* equation :
       {"f_r(l, v) = g(v, l)", "f_r(l, v) = 2 f_r(v, l)", "f(x) = f(2)", "f = f", "D = \\frac{D_0}{d}", "a = d / 2",
        "G = \\frac{d + 1}{d + 2}", "a = \\frac{d}{d}", "\\theta_i = 0"}) {
    EXPECT_FALSE(is_background("\\[" + std::string(equation) + "\\]")) << equation;
  }
  for (const char* prose : {"$\\theta_i = \\theta_o$", "$\\alpha = 0$"}) EXPECT_FALSE(is_background(prose)) << prose;
}

}  // namespace
}  // namespace texbrdf
