#include "analysis/snapshot.h"

#include <gtest/gtest.h>

#include <thread>

#include "reports.h"
#include "support/read_file.h"

namespace texbrdf {
namespace {

using test::equations;

// The document with "|" taken out, and where it stood.
struct Cursor {
  explicit Cursor(std::string text) : offset(static_cast<uint32_t>(text.find('|'))), document(text.erase(offset, 1)) {}
  std::optional<Occurrence> occurrence() { return document.snapshot().occurrence_at(offset); }
  std::string text(const Occurrence& o) { return document.text().slice(o.span); }
  uint32_t offset;
  Document document;
};

TEST(OccurrenceAt, FindsTheNameThatTheCursorTouches) {
  for (const char* body :
       {"f = |\\rho_d + 1", "f = \\rh|o_d + 1", "f = \\rho_d| + 1", "f = 2*|\\rho_d+1", "f = 2*\\rho_d|+1"}) {
    Cursor cursor(equations({"\\rho_d = 1", body}));
    const auto found = cursor.occurrence();
    ASSERT_TRUE(found) << body;
    EXPECT_EQ(cursor.text(*found), "\\rho_d");
    EXPECT_EQ(found->target, DefinitionId{0});
    EXPECT_EQ(found->inside, DefinitionId{1});
    EXPECT_FALSE(found->is_definition);
  }
}

TEST(OccurrenceAt, TheNameBehindTheCursorWins) {
  Cursor cursor(equations({"a = 1", "f = \\pi|a"}));
  const auto found = cursor.occurrence();
  ASSERT_TRUE(found);
  EXPECT_EQ(cursor.text(*found), "\\pia");
}

TEST(OccurrenceAt, ADecoratedNameIsOne) {
  Cursor cursor(equations({"f = \\vec{\\ome|ga_i} \\cdot \\vec{n}"}));
  const auto found = cursor.occurrence();
  ASSERT_TRUE(found);
  EXPECT_EQ(cursor.text(*found), "\\vec{\\omega_i}");
  EXPECT_EQ(found->referent.kind, Referent::Kind::Convention);
  EXPECT_EQ(static_cast<Convention>(found->referent.index), Convention::OmegaI);
}

TEST(OccurrenceAt, KnowsDeclarations) {
  Cursor name(equations({"|g(x) = x", "f = g(1)"}));
  ASSERT_TRUE(name.occurrence());
  EXPECT_TRUE(name.occurrence()->is_definition);
  EXPECT_EQ(name.occurrence()->target, DefinitionId{0});

  Cursor parameter(equations({"g(y, |x) = x", "f = g(1, 1)"}));
  ASSERT_TRUE(parameter.occurrence());
  EXPECT_TRUE(parameter.occurrence()->is_definition);
  EXPECT_EQ(parameter.occurrence()->referent, (Referent{Referent::Kind::Parameter, 1}));
}

TEST(OccurrenceAt, IsNothingElsewhere) {
  for (const char* text :
       {"|prose", "prose \\begin{equation} f = | 1 + 2 \\end{equation}", "\\be|gin{equation} f = 1\\end{equation}",
        "\\begin{equation} f = 1 \\end{equation} prose|", "|"}) {
    Cursor cursor(text);
    EXPECT_FALSE(cursor.occurrence()) << text;
  }
}

std::vector<uint32_t> lines_of(Cursor& cursor) {
  std::vector<uint32_t> lines;
  const Snapshot& snapshot = cursor.document.snapshot();
  for (const Occurrence& o : snapshot.occurrences_of(*cursor.occurrence())) {
    lines.push_back(snapshot.text().position(o.span.begin, ColumnUnit::Utf8).line + 1);
  }
  return lines;
}

TEST(OccurrencesOf, AreAllPlacesOfOneThingInOrder) {
  Cursor definition(equations({"b = a", "|a = 1", "g(a) = a", "f = a + a * g(a)"}));
  EXPECT_EQ(lines_of(definition), (std::vector<uint32_t>{2, 6, 14, 14, 14})) << "not the parameter of g";
  Cursor parameter(equations({"b = a", "a = 1", "g(|a) = a", "f = a + g(a)"}));
  EXPECT_EQ(lines_of(parameter), (std::vector<uint32_t>{10, 10}));
  Cursor convention(equations({"b = \\omega_i", "g(\\omega_i) = \\omega_i", "f = |\\vec{\\omega_i} \\cdot b"}));
  EXPECT_EQ(lines_of(convention), (std::vector<uint32_t>{2, 10}));
  Cursor undefined(equations({"b = |q", "f = q"}));
  EXPECT_EQ(lines_of(undefined), (std::vector<uint32_t>{2, 6}));
  Cursor unread(equations({"b = \\foo{|a}", "a = 1", "f = a"}));
  EXPECT_EQ(lines_of(unread), (std::vector<uint32_t>{2})) << "what is not read is no use of `a`";
  Cursor constant(equations({"|\\pi = 3", "f = \\pi"}));
  EXPECT_EQ(lines_of(constant), (std::vector<uint32_t>{2})) << "the other one is that of the convention";
}

TEST(Snapshot, FindsTheDefinitionInForce) {
  Document document(equations({"a = 1", "a = 2", "\\pi = 3"}));
  const Snapshot& snapshot = document.snapshot();
  EXPECT_EQ(snapshot.find("a"), DefinitionId{0});
  EXPECT_FALSE(snapshot.definition(DefinitionId{1}).in_force);
  EXPECT_FALSE(snapshot.find("\\pi"));
  EXPECT_FALSE(snapshot.find("zzz"));
  EXPECT_EQ(snapshot.linkable(snapshot.names().find("\\pi")), nullptr);
}

struct EquationCase {
  const char* block;
  const char* equation;
};

TEST(Equation, IsOneLineOfSource) {
  const EquationCase cases[] = {
      {"  f =\n   1 +\t 2  ", "f = 1 + 2"},
      {"f = 1 % one\n + 2 % two", "f = 1 + 2"},
      {"\\label{eq:f} f = \\label{x} 1 \\nonumber \\\\", "f = 1"},
      {"f = \\left( 1 \\right)", "f = \\left( 1 \\right)"},
      {"f = \\text{a\n b}", "f = \\text{a b}"},
      {"f = 1 \\tag{3}", "f = 1"},
      {"\\displaystyle f = \\frac{1}{2}\\,\\cdot 3", "f = \\frac{1}{2}\\,\\cdot 3"},
      {"f = 1 \\notag + \\\\ 2", "f = 1 + 2"},
  };
  for (const EquationCase& expected : cases) {
    Document document(std::string("\\begin{equation}") + expected.block + "\\end{equation}");
    ASSERT_EQ(document.snapshot().definitions().size(), 1u) << expected.block;
    EXPECT_EQ(document.snapshot().equation(DefinitionId{0}), expected.equation);
  }
}

struct Constant {
  const char* body;
  std::optional<std::vector<double>> value;
};

TEST(ConstantValue, IsThereWhereNothingDependsOnDirections) {
  const Constant constants[] = {
      {"x = 2", {{2.0}}},           {"x = m * 4 + 1", {{3.0}}},      {"x = \\vec{1, 0.5, 0} * m", {{0.5, 0.25, 0.0}}},
      {"x = g(3)", {{9.0}}},        {"x = 0 * \\pi", {{0.0}}},       {"x = \\sqrt{16} + \\max(1, 2, 3)", {{7.0}}},
      {"x = c \\cdot c", {{1.25}}}, {"x = \\theta_i", std::nullopt}, {"x = \\vec{n} * 2", std::nullopt},
      {"x(y) = 2", std::nullopt},   {"x = q", std::nullopt},         {"x = q + 1", std::nullopt},
      {"x = e", std::nullopt},      {"x = t * 0", std::nullopt},
  };
  for (const Constant& expected : constants) {
    Document document(
        equations({"m = 0.5", "c = \\vec{1, 0.5, 0}", "g(a) = a^2", "e = q + 1", "t = \\theta_i", expected.body}));
    const Snapshot& snapshot = document.snapshot();
    EXPECT_EQ(snapshot.constant_value(*snapshot.find("x")), expected.value) << expected.body;
  }
}

TEST(Program, HoldsWhatTheRootNeeds) {
  Document document(equations({"m = 0.5 % range [0.1, 1]", "unused = 3", "g(x) = x * m", "f = g(\\theta_i)"}));
  const Result<ir::Program> program = document.snapshot().program();
  ASSERT_TRUE(program) << program.error();
  ASSERT_EQ(program->parameters.size(), 1u);
  EXPECT_EQ(program->parameters[0].canonical, "m");
  EXPECT_EQ(program->parameters[0].minimum, 0.1);
  EXPECT_EQ(program->root().canonical, "f");
  EXPECT_EQ(program->root().equation, "f = g(\\theta_i)");
}

TEST(Program, SaysWhyItCannotBeHad) {
  struct Failing {
    std::vector<std::string> bodies;
    const char* reason;
  };
  const Failing failing[] = {
      {{"a = 1"}, "no equation defines `f`"},
      {{"a = q", "f = a"}, "`f` cannot be used: it or something that it needs has an error"},
      {{"f = q + 1"}, "`f` cannot be used: it or something that it needs has an error"},
      {{"a = q \\times q", "b = a", "f = b"}, "`b` uses a name whose definition is missing or has errors"},
      {{"g(x) = x + q", "f = \\sin(g(1))"}, "`f` cannot be used: it or something that it needs has an error"},
      {{"f(x) = x"}, "`f` is ℝ → ℝ, but a BRDF is ℝ or ℝ³, plain or a function of two vectors"},
  };
  for (const Failing& expected : failing) {
    Document document(equations(expected.bodies));
    const Result<ir::Program> program = document.snapshot().program();
    ASSERT_FALSE(program);
    EXPECT_EQ(program.error(), expected.reason);
  }
}

TEST(Program, ErrorsThatTheRootDoesNotNeedAreNoHindrance) {
  Document document(equations({"a = q", "f = 1"}));
  EXPECT_FALSE(document.snapshot().has_errors()) << "a paper also contains equations that are not code";
  EXPECT_TRUE(document.snapshot().program());
}

TEST(Snapshot, IsReadByThreadsWhileTheDocumentChanges) {
  Document document(test::read_file(TEXBRDF_TEST_DATA "/models/cook-torrance.tex"));
  const Snapshot snapshot = document.snapshot();
  std::vector<std::thread> readers;
  for (int i = 0; i < 3; ++i) {
    readers.emplace_back([snapshot] {
      for (int k = 0; k < 50; ++k) {
        ASSERT_TRUE(snapshot.diagnostics().empty());
        ASSERT_TRUE(snapshot.program());
        ASSERT_TRUE(snapshot.find("\\rho_d"));
      }
    });
  }
  for (int k = 0; k < 50; ++k) {
    document.replace({0, 0}, "\\begin{equation}x_{" + std::to_string(k) + "} = 1\\end{equation}\n");
    document.snapshot().diagnostics();
  }
  for (std::thread& reader : readers) reader.join();
}

}  // namespace
}  // namespace texbrdf
