#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "reports.h"
#include "support/read_file.h"

namespace texbrdf {
namespace {

struct Expected {
  const char* document;
  std::vector<std::string> reports;
};

void PrintTo(const Expected& e, std::ostream* out) {
  *out << e.document;
}

const std::vector<Expected>& expected_reports() {
  static const std::vector<Expected> all = {
      {"undefined", {"E3001 2:17 [\\text{var}] undefined name `\\text{var}` in the definition of `f`"}},
      {"exp-of-vector", {"E4002 2:14 [\\vec{1,1,1}] operand of `\\exp`: expected ℝ or RGB, got ℝ³"}},
      {"unbalanced", {"E2003 2:9 [(] `(` is never closed"}},
      {"reserved-word", {"E3002 2:9 [arccos] `arccos` is a reserved word; the command is `\\arccos`"}},
      {"no-expression", {"E2001 3:1 [\\end] expected an expression, found the end of the equation"}},
      {"redefinition", {"E3006 6:5 [f] `f` is defined more than once; another definition is in force"}},
      {"cycle", {"E3009 2:5 [a] circular definition: `a` → `f` → `a`"}},
      {"argument-type", {"E4003 6:14 [\\vec{1,1,1}] 2nd argument of `g`: expected ℝ, got ℝ³"}},
      {"argument-count", {"E4004 6:9 [g(1)] `g` takes 2 arguments, got 1"}},
      {"not-a-function", {}},  // a product
      {"missing-f", {"E3010 2:5 [a] no equation defines `f`, the BRDF"}},
      {"vector-power", {"E4002 2:12 [\\vec{n}] operand of `^`: expected ℝ or RGB, got ℝ³"}},
      {"vector-plus-real",
       {"E4001 2:17 [+] `+` between ℝ³ and ℝ: it needs two operands of the same type, or a colour and a real"}},
      {"vector-over-vector",
       {"E4001 2:17 [/] `/` between ℝ³ and ℝ³: it needs a real below the line, or a colour and no vector above it"}},
      {"vector-length", {"E2009 2:9 [\\vec{1,2}] a vector literal has 3 numbers, not 2"}},
      {"missing-end", {"E2005 1:1 [\\begin{equation}] `\\begin{equation}` has no `\\end{equation}`"}},
      {"two-errors",
       {"E3001 2:9 [\\text{p}] undefined name `\\text{p}` in the definition of `a`",
        "E4002 6:14 [\\vec{n}] operand of `\\exp`: expected ℝ or RGB, got ℝ³"}},
      {"no-cascade", {"E3001 2:9 [\\text{p}] undefined name `\\text{p}` in the definition of `a`"}},
      {"builtin-redefined", {}},
      {"left-side", {"E2007 2:5 [1 + 2] the left side defines nothing"}},
      {"missing-operator", {"E3001 2:10 [x] undefined name `x` in the definition of `f`"}},
      {"poisoned-parameter", {"E3001 2:21 [\\text{p}] undefined name `\\text{p}` in the definition of `g`"}},
      {"stray-closer", {"E2004 2:14 [)] `)` closes nothing"}},
      {"unbalanced-brace", {"E2003 2:11 [{] `{` is never closed"}},
      {"unknown-command", {"E3003 2:9 [\\foo] unknown command `\\foo`"}},
      {"pi-redefined", {"E3007 2:5 [\\pi] `\\pi` is a constant and cannot be redefined"}},
  };
  return all;
}

class ErrorDocument : public testing::TestWithParam<Expected> {};

TEST_P(ErrorDocument, GivesExactlyItsErrors) {
  const std::string text = test::read_file(std::string(TEXBRDF_TEST_DATA "/errors/") + GetParam().document + ".tex");
  Document document(text);
  EXPECT_EQ(test::reports(document.snapshot(), Severity::Warning), GetParam().reports);
  EXPECT_EQ(document.snapshot().has_errors(), !GetParam().reports.empty());
}

TEST_P(ErrorDocument, GivesTheSameAnywhere) {
  const std::string text = test::read_file(std::string(TEXBRDF_TEST_DATA "/errors/") + GetParam().document + ".tex");
  Document here(text);
  Document there("prose — ünïcödé\r\n$x$ " + text);
  const auto at_home = here.snapshot().diagnostics();
  const auto away = there.snapshot().diagnostics();
  ASSERT_EQ(at_home.size(), away.size());
  for (size_t i = 0; i < at_home.size(); ++i) {
    EXPECT_EQ(at_home[i].where, away[i].where);
    EXPECT_EQ(message(at_home[i]), message(away[i]));
  }
}

INSTANTIATE_TEST_SUITE_P(All, ErrorDocument, testing::ValuesIn(expected_reports()));

TEST(ErrorDocuments, AreAllListed) {
  std::set<std::string> listed;
  for (const Expected& expected : expected_reports()) listed.insert(expected.document);
  std::set<std::string> present;
  for (const auto& file : std::filesystem::directory_iterator(TEXBRDF_TEST_DATA "/errors")) {
    if (file.path().extension() == ".tex") present.insert(file.path().stem());
  }
  EXPECT_EQ(listed, present);
}

std::vector<std::filesystem::path> documents(const char* folder) {
  std::vector<std::filesystem::path> found;
  for (const auto& file : std::filesystem::recursive_directory_iterator(std::string(TEXBRDF_TEST_DATA "/") + folder)) {
    if (file.path().extension() == ".tex") found.push_back(file.path());
  }
  return found;
}

TEST(Models, AreWithoutFault) {
  // LaTeX rejects the chain of powers that this one shows on purpose.
  const std::vector<std::string> chain = {"E2012 22:14 [^] a power of a power is read as `1.1^{2^3}`"};
  const auto models = documents("models");
  ASSERT_EQ(models.size(), 12u);
  for (const auto& path : models) {
    Document document(test::read_file(path));
    const Snapshot& snapshot = document.snapshot();
    const bool has_chain = path.stem() == "conventions";
    EXPECT_EQ(test::reports(snapshot, Severity::Warning), has_chain ? chain : std::vector<std::string>{}) << path;
    for (const Definition& definition : snapshot.definitions()) {
      EXPECT_TRUE(definition.checked->sound) << path << ": " << snapshot.names().text(definition.name);
      EXPECT_NE(snapshot.linkable(definition.name), nullptr) << path;
    }
    const Result<ir::Program> program = snapshot.program();
    ASSERT_TRUE(program) << path << ": " << program.error();
    EXPECT_EQ(program->root().canonical, "f");
  }
}

TEST(Papers, GiveAnAnswer) {
  for (const auto& path : documents("papers")) {
    Document document(test::read_file(path));
    const Snapshot& snapshot = document.snapshot();
    for (const Diagnostic& d : snapshot.diagnostics()) {
      const Span span = snapshot.absolute(d.where);
      EXPECT_LE(span.begin, span.end) << path;
      EXPECT_LE(span.end, snapshot.text().size()) << path;
      EXPECT_FALSE(message(d).empty());
    }
    EXPECT_FALSE(snapshot.program() && snapshot.has_errors() && path.parent_path().stem() != "bad") << path;
  }
}

}  // namespace
}  // namespace texbrdf
