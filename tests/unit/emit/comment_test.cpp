#include "emit/comment.h"

#include <gtest/gtest.h>

#include <sstream>

namespace texbrdf::emit {
namespace {

TEST(Comment, ShowsTheEquation) {
  EXPECT_EQ(equation_comment("a = \\frac{1}{2}", 2), "  // a = \\frac{1}{2}\n");
  EXPECT_EQ(equation_comment("a =\t\n  b", 0), "// a = b\n");
  EXPECT_EQ(equation_comment("", 2), "");
}

TEST(Comment, IsPlainAscii) {
  EXPECT_EQ(equation_comment("\\text{\xC3\xA9t\xC3\xA9} = 1", 0), "// \\text{?t?} = 1\n");
}

TEST(Comment, NeverContinuesOnTheNextLine) {
  EXPECT_EQ(equation_comment("a = 1 \\", 0), "// a = 1 \\ .\n");
  std::istringstream lines(equation_comment(std::string(300, '\\'), 0));
  for (std::string line; std::getline(lines, line);) EXPECT_FALSE(line.ends_with('\\')) << line;
}

TEST(Comment, BreaksOutsideOfBracesWhereItCan) {
  const std::string factor = "\\text{first word, second word, third word}";
  EXPECT_EQ(equation_comment("a = " + factor + " * " + factor + " * " + factor, 0),
            "// a = " + factor + " * " + factor + " *\n//     " + factor + "\n");
}

TEST(Comment, KeepsLinesShort) {
  for (const std::string& text : {std::string(1000, 'x'), std::string(500, '(') + " " + std::string(500, ')')}) {
    std::istringstream lines(equation_comment(text, 2));
    for (std::string line; std::getline(lines, line);) EXPECT_LT(line.size(), 100u);
  }
}

}  // namespace
}  // namespace texbrdf::emit
