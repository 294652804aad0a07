#include "semantics/parameter.h"

#include <gtest/gtest.h>

#include "syntax/block_scanner.h"

namespace texbrdf {
namespace {

struct Read {
  std::optional<ParameterLiteral> literal;
  std::vector<std::string> reports;
};

Read read(const std::string& equation) {
  const std::string text = "\\begin{equation}\n" + equation + "\n\\end{equation}";
  const ParsedBlock block = parse_block(text, scan_blocks(text).at(0));
  std::vector<Diagnostic> diagnostics;
  Read result{parameter_literal(block, block.definitions.at(0), diagnostics), {}};
  for (const Diagnostic& d : diagnostics) result.reports.push_back(code_name(d.code) + " " + message(d));
  return result;
}

struct Range {
  const char* equation;
  double value, minimum, maximum;
};

TEST(ParameterLiteral, HasARangeThatContainsItsValue) {
  const Range ranges[] = {
      {"m = 0.13", 0.13, 0, 1},
      {"m = 0", 0, 0, 1},
      {"m = 1", 1, 0, 1},
      {"n = 1.5", 1.5, 0, 10},
      {"n = 300", 300, 0, 1000},
      {"n = 1000", 1000, 0, 1000},
      {"n = -0.5", -0.5, -1, 1},
      {"n = -+-+.5", .5, 0, 1},
      {"n = -20", -20, -100, 100},
      {"n = 1e-3", 1e-3, 0, 1},
      {"m = 0.13 % range [0.01, 1]", 0.13, 0.01, 1},
      {"m = 0.13 %range[ -1 , +2e1 ] of the slope", 0.13, -1, 20},
      {"m = 0.13 % a comment\n% range [0, 0.2]", 0.13, 0, 0.2},
      {"m = 0.13 % range of the slope", 0.13, 0, 1},
  };
  for (const Range& expected : ranges) {
    const Read found = read(expected.equation);
    ASSERT_TRUE(found.literal) << expected.equation;
    EXPECT_EQ(found.literal->type, Type::Real) << expected.equation;
    EXPECT_EQ(found.literal->value[0], expected.value) << expected.equation;
    EXPECT_EQ(found.literal->minimum, expected.minimum) << expected.equation;
    EXPECT_EQ(found.literal->maximum, expected.maximum) << expected.equation;
    EXPECT_TRUE(found.reports.empty()) << expected.equation;
  }
}

TEST(ParameterLiteral, ReadsColours) {
  for (const char* equation : {"c = \\vec{0.25, 0, +1}", "c = (0.25, 0, +1)"}) {
    const Read found = read(equation);
    ASSERT_TRUE(found.literal) << equation;
    EXPECT_EQ(found.literal->type, Type::Colour) << equation;
    EXPECT_EQ(found.literal->value, (std::array<double, 3>{0.25, 0, 1})) << equation;
    EXPECT_EQ(found.literal->minimum, 0) << equation;
    EXPECT_EQ(found.literal->maximum, 1) << equation;
  }
}

TEST(ParameterLiteral, IsNothingElse) {
  for (const char* equation :
       {"m = 0.13 % constant", "m = 1 + 2", "g(x) = 2", "c = \\vec{0, 0, 2}", "c = \\vec{0, -0.5, 1}",
        "c = (0, 0, 1.1)", "c = (0, 0, q)", "c = (0, 1)", "m = (2)", "m = q", "m = 1e999"}) {
    EXPECT_FALSE(read(equation).literal) << equation;
  }
  EXPECT_TRUE(read("m = 2 % constant in most papers").literal);
}

TEST(ParameterLiteral, ReportsRangesThatAreNone) {
  const std::string malformed = "E4007 a range is written `% range [a, b]` with a < b";
  struct Bad {
    const char* equation;
    std::string report;
  };
  const Bad bad[] = {
      {"m = 0.5 % range [0, 1", malformed},
      {"m = 0.5 % range 0, 1", malformed},
      {"m = 0.5 % range [1, 0]", malformed},
      {"m = 0.5 % range [1, 1]", malformed},
      {"m = 0.5 % range (0, 1)", malformed},
      {"m = 0.5 % range [0; 1]", malformed},
      {"m = 0.5 % range [0, inf]", malformed},
      {"m = 3 % range [0, 1]", "E4008 the range [0, 1] leaves out the value 3"},
      {"c = \\vec{0.5, 0.1, 0.75} % range [0.2, 0.8]", "E4008 the range [0.2, 0.8] leaves out the value 0.1"},
  };
  for (const Bad& expected : bad) {
    const Read found = read(expected.equation);
    EXPECT_EQ(found.reports, std::vector{expected.report}) << expected.equation;
    ASSERT_TRUE(found.literal) << expected.equation;
    EXPECT_EQ(found.literal->minimum, 0) << "the usual range holds: " << expected.equation;
  }
}

}  // namespace
}  // namespace texbrdf
