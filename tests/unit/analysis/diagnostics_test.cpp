#include <gtest/gtest.h>

#include "reports.h"

namespace texbrdf {
namespace {

using test::equations;
using test::reports;

struct Case {
  const char* what;
  std::vector<std::string> bodies;
  std::vector<std::string> expected;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.what;
}

class WholeDocument : public testing::TestWithParam<Case> {};

TEST_P(WholeDocument, IsReported) {
  Document document(equations(GetParam().bodies));
  EXPECT_EQ(reports(document.snapshot()), GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Diagnostics, WholeDocument,
    testing::ValuesIn(std::vector<Case>{
        {"nearest name",
         {"roughness = 1", "f = rougness + pi"},
         {"E3013 2:1 [roughness] nothing uses `roughness`",
          "E3001 6:5 [rougness] undefined name `rougness` in the definition of `f`; did you mean `roughness`?",
          "E3001 6:16 [pi] undefined name `pi` in the definition of `f`; did you mean `\\pi`?"}},
        {"nearest name is a parameter",
         {"alphb = 1", "g(alpha) = alph * alpha", "f = g(alphb)"},
         {"E3001 6:12 [alph] undefined name `alph` in the definition of `g`; did you mean `alpha`?"}},
        {"a prime in a subscript is no derivative",
         {"f = \\rho_{s'}(2)"},
         {"E3001 2:5 [\\rho_{s'}] undefined name `\\rho_{s'}` in the definition of `f`"}},
        {"what a function is made of, outside of it",
         {"F(c) = g", "g = c + 1", "k = 2g", "f = k"},
         {"E3013 2:1 [F] nothing uses `F`", "E3001 6:5 [c] undefined name `c` in the definition of `g`"}},
        {"what a function is made of, in another",
         {"F(c) = g", "g = c + 1", "H(x) = g x", "f = F(1) + H(2)"},
         {"E3001 10:8 [g] undefined name `c` in the definition of `g`"}},
        {"the first of two stays in force",
         {"a = 1", "a = \\vec{n}", "f = a + 1"},
         {"E3006 6:1 [a] `a` is defined more than once; another definition is in force"}},
        {"the body of a later definition is checked",
         {"a = 1", "a = q", "f = a"},
         {"E3006 6:1 [a] `a` is defined more than once; another definition is in force",
          "E3001 6:5 [q] undefined name `q` in the definition of `a`"}},
        {"a later definition may mention the first",
         {"a = 1", "a = a + 1", "f = a"},
         {"E3006 6:1 [a] `a` is defined more than once; another definition is in force"}},
        {"a constant stays what it is",
         {"\\pi = \\vec{n}", "\\pi = 2", "f = \\pi + 1"},
         {"E3007 2:1 [\\pi] `\\pi` is a constant and cannot be redefined",
          "E3007 6:1 [\\pi] `\\pi` is a constant and cannot be redefined"}},
        {"a convention redefined is a hint",
         {"\\vec{h} = \\vec{n}", "f = \\cos\\theta_h * \\vec{h}"},
         {"E3008 2:1 [\\vec{h}] `\\vec{h}` takes the place of the convention: half vector"}},
        {"a convention in both spellings is one name",
         {"\\vec{\\omega_i} = \\vec{n}", "f = \\omega_i"},
         {"E3008 2:1 [\\vec{\\omega_i}] `\\omega_i` takes the place of the convention: unit vector towards the light"}},
        {"a definition of itself", {"f = f + 1"}, {"E3009 2:5 [f] circular definition: `f` → `f`"}},
        {"a cycle is named from its first definition",
         {"f = a", "c = a", "a = b", "b = c"},
         {"E3009 6:1 [c] circular definition: `c` → `a` → `b` → `c`"}},
        {"two cycles",
         {"a = b", "b = a", "c(x) = d(x)", "d(x) = c(x)", "f = a + c(1)"},
         {"E3009 2:1 [a] circular definition: `a` → `b` → `a`", "E3009 10:1 [c] circular definition: `c` → `d` → `c`"}},
        {"a cycle hides no other error",
         {"a = b + q", "b = a", "f = a"},
         {"E3009 2:1 [a] circular definition: `a` → `b` → `a`",
          "E3001 2:9 [q] undefined name `q` in the definition of `a`"}},
        {"a parameter is no cycle", {"a(b) = b", "b = a(1)", "f = b"}, {}},
        {"missing root", {"a = 1", "b(x) = x"}, {"E3010 6:1 [b] no equation defines `f`, the BRDF"}},
        {"missing root and other errors",
         {"a = q"},
         {"E3010 2:1 [a] no equation defines `f`, the BRDF",
          "E3001 2:5 [q] undefined name `q` in the definition of `a`"}},
        {"an unread left side may be the root",
         {"a = 1", "1 + 2 = 3"},
         {"E2007 6:1 [1 + 2] the left side defines nothing"}},
        {"an unread body of the root", {"f = ( + 1"}, {"E2003 2:5 [(] `(` is never closed"}},
        {"root of one vector",
         {"f(\\vec{x}) = \\vec{x}"},
         {"E4006 2:1 [f] `f` is ℝ³ → ℝ³, but a BRDF is ℝ or ℝ³, plain or a function of two vectors"}},
        {"root of two reals",
         {"f(a, b) = a * b"},
         {"E4006 2:1 [f] `f` is ℝ × ℝ → ℝ, but a BRDF is ℝ or ℝ³, plain or a function of two vectors"}},
        {"root of two vectors", {"f(\\vec{a}, \\vec{b}) = \\vec{a} \\cdot \\vec{b}"}, {}},
        {"plain colour", {"f = \\vec{1, 1, 1}"}, {}},
        {"the shape of a root in error is not told",
         {"f(\\vec{x}) = q + \\vec{x}"},
         {"E3001 2:14 [q] undefined name `q` in the definition of `f`"}},
        {"the shape of a root whose needs are in error is",
         {"a = \\vec{n} + q", "f(\\vec{x}) = a + \\vec{x}"},
         {"E3001 2:15 [q] undefined name `q` in the definition of `a`",
          "E4006 6:1 [f] `f` is ℝ³ → ℝ³, but a BRDF is ℝ or ℝ³, plain or a function of two vectors"}},
        {"a root in error has no shape", {"f(x) = q"}, {"E3001 2:8 [q] undefined name `q` in the definition of `f`"}},
        {"malformed range",
         {"m = 0.5 % range [1, 0]", "f = m"},
         {"E4007 2:9 [% range [1, 0]] a range is written `% range [a, b]` with a < b"}},
        {"range without the value",
         {"m = 5 % range [0, 1]", "f = m"},
         {"E4008 2:7 [% range [0, 1]] the range [0, 1] leaves out the value 5"}},
    }));

TEST(Diagnostics, OtherRoots) {
  Document document(equations({"a = 1", "g(x) = x * a"}));
  EXPECT_TRUE(reports(document.snapshot(), Severity::Warning, "a").empty());
  EXPECT_EQ(reports(document.snapshot(), Severity::Hint, "g"),
            std::vector<std::string>{
                "E4006 6:1 [g] `g` is ℝ → ℝ, but a BRDF is ℝ or ℝ³, plain or a function of two vectors"});
  EXPECT_EQ(reports(document.snapshot(), Severity::Hint, "z"),
            std::vector<std::string>{"E3010 6:1 [g] no equation defines `z`, the BRDF"});
}

TEST(Diagnostics, ADocumentWithoutEquationsHasNone) {
  Document document("Only prose, $x > 1$.");
  EXPECT_TRUE(reports(document.snapshot()).empty());
  EXPECT_FALSE(document.snapshot().has_errors());
}

TEST(Diagnostics, BrokenBlocksAreReportedEachAndSpareTheOthers) {
  std::vector<std::string> bodies = {"good = 2"};
  const std::vector<std::string> broken = {"b = ", "c = (1", "d = 1)", "e = 2 +", "h = \\frac{1}", "i = @"};
  bodies.insert(bodies.end(), broken.begin(), broken.end());
  bodies.push_back("f = good * \\vec{n}");
  bodies.push_back("g = b * c * d * e * h * i");
  Document document(equations(bodies));
  EXPECT_EQ(reports(document.snapshot(), Severity::Error, "g").size(), broken.size());
  EXPECT_EQ(reports(document.snapshot(), Severity::Error).size(), 0u);
  EXPECT_TRUE(document.snapshot().program());
}

TEST(Diagnostics, RelatedPlacesPointIntoTheirBlocks) {
  Document document(equations({"a = b", "b = a", "c = 1", "c = 2", "f = a + c"}));
  const Snapshot& snapshot = document.snapshot();
  const auto all = snapshot.diagnostics();
  ASSERT_EQ(all.size(), 2u);
  ASSERT_EQ(all[0].related.size(), 1u);
  EXPECT_EQ(snapshot.text().slice(snapshot.absolute(all[0].related[0].where)), "b");
  EXPECT_EQ(all[0].related[0].message, "`b` is on the way");
  ASSERT_EQ(all[1].related.size(), 1u);
  EXPECT_EQ(all[1].related[0].where.block, BlockId{2});
  EXPECT_EQ(all[1].related[0].message, "this one is in force");
}

TEST(Diagnostics, FixesMendTheDocument) {
  struct Mend {
    std::vector<std::string> bodies;
    const char* title;
    std::vector<std::string> mended;
  };
  const Mend mends[] = {
      {{"a = 1", "f = a*pi"}, "replace by `\\pi`", {"a = 1", "f = a*\\pi"}},
      {{"f = 2 3"}, "insert `\\cdot`", {"f = 2 \\cdot 3"}},
      {{"f = exp(1)"}, "write `\\exp`", {"f = \\exp(1)"}},
      {{"g(x) = x \\times \\vec{n}", "f = g(\\vec{h})"},
       "write `\\vec{x}`",
       {"g(\\vec{x}) = \\vec{x} \\times \\vec{n}", "f = g(\\vec{h})"}},
  };
  for (const Mend& mend : mends) {
    Document document(equations(mend.bodies));
    const auto all = document.snapshot().diagnostics();
    ASSERT_EQ(all.size(), 1u);
    ASSERT_EQ(all[0].fixes.size(), 1u);
    EXPECT_EQ(all[0].fixes[0].title, mend.title);
    const Snapshot before = document.snapshot();
    const auto& edits = all[0].fixes[0].edits;
    for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) {
      document.replace(before.absolute(edit->where), edit->replacement);
    }
    EXPECT_EQ(document.text().bytes(), equations(mend.mended));
    EXPECT_TRUE(document.snapshot().diagnostics().empty());
  }
}

TEST(Diagnostics, ALongCycleIsToldFromItsStart) {
  std::vector<std::string> bodies = {"f = a_{0}"};
  for (int i = 0; i < 50; ++i)
    bodies.push_back("a_{" + std::to_string(i) + "} = a_{" + std::to_string((i + 1) % 50) + "}");
  Document document(equations(bodies));
  const auto all = document.snapshot().diagnostics();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_TRUE(message(all[0]).starts_with("circular definition: `a_0` → `a_1` → "));
  EXPECT_TRUE(message(all[0]).ends_with(" → … → `a_0`"));
  EXPECT_EQ(all[0].related.size(), 11u);
}

TEST(Diagnostics, ManyUndefinedNamesAreStillReadQuickly) {
  std::vector<std::string> bodies;
  for (int i = 0; i < 3000; ++i)
    bodies.push_back("name_{" + std::to_string(i) + "} = nmae_{" + std::to_string(i) + "}");
  bodies.push_back("f = 1");
  Document document(equations(bodies));
  EXPECT_EQ(reports(document.snapshot()).size(), 3000u + 100u) << "of unused definitions the first hundred are told";
}

}  // namespace
}  // namespace texbrdf
