#include <gtest/gtest.h>

#include "analysis/document.h"
#include "reports.h"

namespace texbrdf {
namespace {

using test::equations;
using test::reports;

class Instances : public testing::Test {
 protected:
  void write(const std::vector<std::string>& bodies) { document_.replace({0, UINT32_MAX}, equations(bodies)); }

  void change(std::string_view text, std::string_view by) {
    const size_t begin = document_.text().bytes().find(text);
    ASSERT_NE(begin, std::string_view::npos) << text;
    document_.replace({static_cast<uint32_t>(begin), static_cast<uint32_t>(begin + text.size())}, by);
  }

  uint64_t checked() { return document_.snapshot().counters().definitions_checked; }
  std::string type_of(std::string_view name) {
    const Snapshot snapshot = document_.snapshot();
    return signature_text(snapshot.definition(*snapshot.find(name)).checked->signature);
  }
  std::vector<std::string> errors() { return reports(document_.snapshot(), Severity::Error); }

  Document document_{""};
};

TEST_F(Instances, AnotherArgumentChecksItsCallOnly) {
  write({"m = 0.5", "g(x, y) = x \\cdot y", "a = g(m, 2)", "b = g(\\vec{n}, \\vec{h})", "f = a + b"});
  EXPECT_EQ(checked(), 5u);
  change("g(m, 2)", "g(\\vec{n}, \\vec{n})");
  EXPECT_EQ(checked(), 1u);
  EXPECT_EQ(errors(), std::vector<std::string>{});
  change("g(\\vec{n}, \\vec{n})", "g(2, \\vec{n})");
  EXPECT_EQ(checked(), 2u) << "a is a vector now, which f cannot add";
  EXPECT_EQ(errors().size(), 1u);
}

TEST_F(Instances, ADigitInABodyChecksNothingElse) {
  write({"g(x) = 2x", "k(y) = g(y)", "f = |k(\\vec{n})| + g(2)"});
  checked();
  change("2x", "3x");
  EXPECT_EQ(checked(), 1u);
}

TEST_F(Instances, AnotherResultOfAnInstanceChecksItsCallers) {
  write({"g(x) = 2x", "a = g(3)", "b = g(\\vec{n})", "c = |b|", "f = a + c"});
  EXPECT_EQ(type_of("b"), "ℝ³");
  change("2x", "x \\cdot x");
  EXPECT_EQ(checked(), 4u) << "g, a, b and c; g by itself is of reals as before, and so is c";
  EXPECT_EQ(type_of("g"), "ℝ → ℝ");
  EXPECT_EQ(type_of("b"), "ℝ");
}

TEST_F(Instances, AChangeFarBelowArrives) {
  write({"g(x) = 2x", "k(y) = g(y)", "l(z) = k(z)", "b = l(\\vec{n})", "f = |b|"});
  EXPECT_EQ(type_of("b"), "ℝ³");
  change("2x", "x \\cdot x");
  EXPECT_EQ(type_of("b"), "ℝ");
  change("x \\cdot x", "\\exp(x)");
  ASSERT_EQ(errors().size(), 1u);
  EXPECT_TRUE(errors()[0].ends_with("1st argument of `l`: expected ℝ, got ℝ³")) << errors()[0];
  change("\\exp(x)", "3x");
  EXPECT_EQ(errors(), std::vector<std::string>{});
  EXPECT_EQ(type_of("b"), "ℝ³");
}

TEST_F(Instances, WhatComesIntoForceCounts) {
  write({"g(x) = 2x", "g(x) = x \\cdot x", "b = g(\\vec{n})", "f = |b|"});
  EXPECT_EQ(type_of("b"), "ℝ³");
  change("\\begin{equation}\ng(x) = 2x\n\\end{equation}", "");
  EXPECT_EQ(type_of("b"), "ℝ");
}

TEST_F(Instances, OneThatNeedsItselfIsACircleAsEver) {
  write({"g(x) = 2k(x)", "k(y) = g(y)", "b = g(\\vec{n})", "f = b"});
  ASSERT_EQ(errors().size(), 1u);
  EXPECT_TRUE(errors()[0].starts_with("E3009")) << errors()[0];
}

TEST_F(Instances, TheProgramHoldsEachOnce) {
  write({"g(x, y) = x \\cdot y", "k(x) = g(x, \\vec{n})",
         "f = g(1, 2) + g(3, 4) + g(\\vec{n}, \\vec{h}) + g(\\vec{h}, \\vec{h}) + k(\\vec{h})"});
  const Result<ir::Program> program = document_.snapshot().program();
  ASSERT_TRUE(program) << program.error();
  std::vector<std::string> signatures;
  for (const ir::ProgramDefinition& definition : program->definitions) {
    signatures.push_back(definition.canonical + ": " + signature_text(definition.signature));
  }
  EXPECT_EQ(signatures, (std::vector<std::string>{"g: ℝ × ℝ → ℝ", "g: ℝ³ × ℝ³ → ℝ", "k: ℝ³ → ℝ", "f: ℝ"}));
}

}  // namespace
}  // namespace texbrdf
