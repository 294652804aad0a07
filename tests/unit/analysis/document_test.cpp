#include "analysis/document.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "reports.h"
#include "support/read_file.h"

namespace texbrdf {
namespace {

using test::equations;
using test::reports;

Span find(const Document& document, std::string_view text) {
  const size_t begin = document.text().bytes().find(text);
  EXPECT_NE(begin, std::string_view::npos) << text;
  return {static_cast<uint32_t>(begin), static_cast<uint32_t>(begin + text.size())};
}

std::string type_of(const Snapshot& snapshot, std::string_view name) {
  return signature_text(snapshot.definition(*snapshot.find(name)).checked->signature);
}

TEST(Document, ReplacesText) {
  Document document("abcdef");
  document.replace({2, 4}, "XYZ");
  EXPECT_EQ(document.text().bytes(), "abXYZef");
  document.replace({6, 999}, "!");
  EXPECT_EQ(document.text().bytes(), "abXYZe!");
  document.replace({500, 600}, "?");
  EXPECT_EQ(document.text().bytes(), "abXYZe!?");
  document.replace({3, 1}, "|");
  EXPECT_EQ(document.text().bytes(), "abX|YZe!?");
}

std::string ladder(int steps) {
  std::vector<std::string> bodies = {"a_{0} = 1 + 1"};
  for (int i = 1; i < steps; ++i) {
    bodies.push_back("a_{" + std::to_string(i) + "} = a_{" + std::to_string(i - 1) + "} * 2");
  }
  bodies.push_back("f = a_{" + std::to_string(steps - 1) + "}");
  return equations(bodies);
}

TEST(Document, TakesAnEquationBehindTheLast) {
  Document document(equations({"f = a"}));
  document.replace({UINT32_MAX, UINT32_MAX}, equations({"a = 1", "b = 2"}));
  EXPECT_EQ(document.snapshot().blocks().size(), 3u);
  EXPECT_FALSE(document.snapshot().has_errors());
}

TEST(Document, ADigitRechecksOneDefinition) {
  Document document(ladder(1000));
  EXPECT_EQ(document.snapshot().counters().blocks_parsed, 1001u);
  EXPECT_EQ(document.snapshot().counters().definitions_checked, 1001u);
  const Span digit = find(document, "1 + 1");
  document.replace({digit.begin, digit.begin + 1}, "7");
  EXPECT_EQ(document.snapshot().counters().blocks_parsed, 1u);
  EXPECT_EQ(document.snapshot().counters().definitions_checked, 1u);
  EXPECT_TRUE(reports(document.snapshot()).empty());
}

TEST(Document, ProseCostsNothing) {
  Document document(ladder(100));
  document.snapshot();
  document.replace({0, 0}, "Some words.\n\n");
  EXPECT_EQ(document.snapshot().counters().blocks_parsed, 0u);
  EXPECT_EQ(document.snapshot().counters().definitions_checked, 0u);
  EXPECT_EQ(document.text().slice(document.snapshot().absolute(BlockId{3}, {0, 6})), "\\begin");
}

TEST(Document, AnotherTypeRechecksTheUsersUntilNothingChanges) {
  Document document(equations({"a = 1", "b = a * \\vec{n}", "c = b \\cdot b", "f = c"}));
  EXPECT_EQ(type_of(document.snapshot(), "b"), "ℝ³");
  document.replace(find(document, "1\n"), "\\vec{1, 1, 1}\n");
  EXPECT_EQ(type_of(document.snapshot(), "b"), "ℝ");
  EXPECT_EQ(type_of(document.snapshot(), "c"), "ℝ");
  EXPECT_EQ(document.snapshot().counters().definitions_checked, 3u) << "a, b and c; f saw no change";
}

TEST(Document, ANameThatAppearsMendsItsUsers) {
  Document document(equations({"f = q + g(1)", "g(x) = x"}));
  EXPECT_EQ(reports(document.snapshot()).size(), 1u);
  document.replace({0, 0}, equations({"q = 2"}));
  EXPECT_TRUE(reports(document.snapshot()).empty());
  EXPECT_EQ(document.snapshot().counters().definitions_checked, 2u);
  document.replace(find(document, "q = 2"), "r = 2");
  EXPECT_EQ(reports(document.snapshot(), Severity::Error).size(), 1u);
}

TEST(Document, ABracketBehindANameFollowsWhatTheNameIs) {
  Document document(equations({"k(x) = x + 1", "a = 2k(3)^2", "b = 3 + 4", "c = \\pi(b)", "f = a + b + c"}));
  const auto value_of_a = [&] { return document.snapshot().constant_value(*document.snapshot().find("a"))->at(0); };
  EXPECT_EQ(value_of_a(), 32);
  document.replace(find(document, "k(x) = x + 1"), "k = 5");
  EXPECT_TRUE(reports(document.snapshot()).empty());
  EXPECT_EQ(value_of_a(), 90);
  EXPECT_EQ(document.snapshot().counters().blocks_parsed, 2u) << "that of k, and its user";
  document.replace(find(document, "k = 5"), "l = 5");
  EXPECT_EQ(reports(document.snapshot(), Severity::Error).size(), 1u) << "a call of what nobody defines";
  document.replace(find(document, "l = 5"), "k(t) = 4");
  EXPECT_EQ(value_of_a(), 32);
}

std::string value_in_force(const Snapshot& snapshot, std::string_view name) {
  return snapshot.equation(*snapshot.find(name));
}

TEST(Document, ADisplayIsInForceBeforeProse) {
  const std::string display = equations({"m = 0.5"});
  Document document("The limit is $m = 0$, and here $m = 0.3$.\n" + equations({"f = m"}));
  EXPECT_EQ(value_in_force(document.snapshot(), "m"), "m = 0.3");
  document.replace({UINT32_MAX, UINT32_MAX}, display);
  EXPECT_EQ(value_in_force(document.snapshot(), "m"), "m = 0.5");
  EXPECT_EQ(reports(document.snapshot(), Severity::Warning), std::vector<std::string>{});
  const auto size = static_cast<uint32_t>(document.text().size());
  document.replace({size - static_cast<uint32_t>(display.size()), size}, "");
  EXPECT_EQ(value_in_force(document.snapshot(), "m"), "m = 0.3");
  document.replace(find(document, "$m = 0.3$"), "");
  EXPECT_EQ(value_in_force(document.snapshot(), "m"), "m = 0");
  document.replace(find(document, "$m = 0$"), "\\[m = 2\\]");
  EXPECT_EQ(value_in_force(document.snapshot(), "m"), "m = 2");
}

TEST(Document, OfNumbersInProseTheLastIsInForce) {
  Document document("GGX is $m = 2$. Here $m = (1, 2, 3)$ or $m = -0.25$; $m = 1$ is flat.\n" + equations({"f = m"}));
  EXPECT_EQ(value_in_force(document.snapshot(), "m"), "m = -0.25");
  document.replace(find(document, "$m = -0.25$"), "");
  EXPECT_EQ(value_in_force(document.snapshot(), "m"), "m = (1, 2, 3)");
  document.replace(find(document, "$m = 2$"), "$m = 2 k$");
  EXPECT_EQ(value_in_force(document.snapshot(), "m"), "m = 2 k");
}

TEST(Document, ANameInAnglesIsWhatTheDocumentDefines) {
  Document document(equations({"E(x) = 2", "f = \\langle E \\rangle"}));
  EXPECT_TRUE(document.snapshot().has_errors()) << "a function without arguments";
  document.replace({0, 0}, equations({"\\langle E \\rangle = 3"}));
  EXPECT_FALSE(document.snapshot().has_errors());
  EXPECT_EQ(value_in_force(document.snapshot(), "\\langle E\\rangle"), "\\langle E \\rangle = 3");
  document.replace(find(document, "\\langle E \\rangle = 3"), "B = 3");
  EXPECT_TRUE(document.snapshot().has_errors());
}

TEST(Document, AVectorHasAHatOfItsOwnWhereTheDocumentTellsThemApart) {
  Document document(equations({"\\vec q = \\omega_i", "f = \\hat q \\cdot \\omega_o"}));
  EXPECT_FALSE(document.snapshot().has_errors());
  document.replace({0, 0}, equations({"\\hat q = 2 \\vec q"}));
  EXPECT_EQ(reports(document.snapshot(), Severity::Hint), std::vector<std::string>{}) << "both are used";
  document.replace(find(document, "2 \\vec q"), "2 \\omega_i");
  EXPECT_TRUE(document.snapshot().has_errors()) << "one name, defined twice";
}

TEST(Document, AnArgumentNeedsAMeaningOnceItIsRead) {
  Document document(equations({"g(x, y) = x", "f = g(1, z)"}));
  EXPECT_FALSE(document.snapshot().has_errors());
  document.replace(find(document, "= x"), "= x + y");
  EXPECT_TRUE(document.snapshot().has_errors());
}

TEST(Document, ThePowerOfACallFollowsWhatTheNameIs) {
  Document document(equations({"a(x) = 2", "f = a^2(3) + 1"}));
  EXPECT_FALSE(document.snapshot().has_errors());
  document.replace(find(document, "a(x)"), "a");
  EXPECT_FALSE(document.snapshot().has_errors());
  EXPECT_EQ(document.snapshot().constant_value(*document.snapshot().find("f")), std::vector<double>{13});
}

TEST(Document, BlocksThatMoveAreKept) {
  Document document(equations({"a = 1", "b = 2", "f = a + b"}));
  document.snapshot();
  document.set_text(equations({"f = a + b", "b = 2", "a = 1"}));
  EXPECT_EQ(document.snapshot().counters().blocks_parsed, 0u);
  EXPECT_EQ(document.snapshot().counters().definitions_checked, 0u);
  EXPECT_TRUE(reports(document.snapshot()).empty());
}

TEST(Document, SnapshotsStayAsTheyWere) {
  Document document(equations({"f = 1"}));
  const Snapshot before = document.snapshot();
  document.replace(find(document, "1"), "\\vec{n}");
  EXPECT_EQ(type_of(document.snapshot(), "f"), "ℝ³");
  EXPECT_EQ(type_of(before, "f"), "ℝ");
  EXPECT_EQ(before.equation(DefinitionId{0}), "f = 1");
  EXPECT_TRUE(before.program());
}

std::string everything_of(const Snapshot& snapshot) {
  std::string all;
  for (const std::string& line : reports(snapshot)) all += line + "\n";
  for (uint32_t i = 0; i < snapshot.definitions().size(); ++i) {
    const Definition& definition = snapshot.definition(DefinitionId{i});
    all += std::string(snapshot.names().text(definition.name)) + ": " + signature_text(definition.checked->signature);
    for (Type type : definition.checked->types) all += type_symbol(type);
    all += (definition.in_force ? " in force " : " later ") + snapshot.equation(DefinitionId{i}) + "\n";
  }
  return all;
}

// Which definition is the root, what it needs and what depends on a direction follow the edits.
TEST(Document, ErrorsAreHintsWhereTheRootDoesNotNeedThem) {
  Document document(equations({"a = q", "b = a + 1", "c = \\theta_h", "f_d = c", "f = c"}));
  const auto severity_after = [&](std::string_view from, std::string_view to) {
    const std::string text = document.text().bytes();
    const auto at = static_cast<uint32_t>(text.rfind(from));
    document.replace({at, at + static_cast<uint32_t>(from.size())}, to);
    const std::vector<Diagnostic> all = document.snapshot().diagnostics();
    return std::ranges::find(all, Code::UndefinedName, &Diagnostic::code)->severity;
  };
  EXPECT_EQ(severity_after("f = c", "f = c + c"), Severity::Hint);
  EXPECT_EQ(severity_after("f = c + c", "f = c + b"), Severity::Error);
  EXPECT_EQ(severity_after("b = a + 1", "b = 1"), Severity::Hint);
  EXPECT_EQ(severity_after("c = \\theta_h", "c = a + b"), Severity::Error);
  EXPECT_EQ(document.snapshot().root_name(), "f");
  EXPECT_EQ(severity_after("f_d = c", "f_d = \\theta_i"), Severity::Hint);
  EXPECT_EQ(document.snapshot().root_name(), "f_d");
  EXPECT_EQ(severity_after("c = a + b", "c = \\phi_i + a"), Severity::Error);
  EXPECT_EQ(document.snapshot().root_name(), "f");
  EXPECT_EQ(severity_after("b = 1", "b = c"), Severity::Error);
  EXPECT_EQ(severity_after("c = \\phi_i + a", "c = b"), Severity::Hint) << "knots say nothing of directions";
  EXPECT_EQ(document.snapshot().root_name(), "f_d");
}

TEST(Document, AfterAnyEditsItIsAsIfReadAnew) {
  const unsigned seed = 20240607;
  std::mt19937 random(seed);
  const std::vector<std::string> pieces = {"\\begin{equation}\n",
                                           "\n\\end{equation}\n",
                                           "%",
                                           "{",
                                           "}",
                                           "(",
                                           ")",
                                           "a",
                                           "b = 1",
                                           " + ",
                                           "\\vec{n}",
                                           "q",
                                           "\n\n",
                                           "f = a + b",
                                           "g(x) = x * 2",
                                           "\\theta_h = 1",
                                           "\\pi",
                                           "1",
                                           "^2",
                                           "\\begin{equation}b = a\\end{equation}",
                                           "\\begin{equation}a = 2\\end{equation}",
                                           "\\begin{verbatim}",
                                           "\\end{verbatim}"};
  Document document(equations({"a = 1", "b = a * \\vec{n}", "g(x) = x + b", "h(y) = g(y) \\cdot b", "f = h(b) * a"}));
  for (int step = 0; step < 1500; ++step) {
    const auto size = static_cast<uint32_t>(document.text().size());
    const uint32_t begin = size == 0 ? 0 : random() % size;
    const uint32_t length = random() % 3 == 0 ? random() % 40 : 0;
    document.replace({begin, begin + length}, pieces[random() % pieces.size()]);
    if (size > 2000) document.set_text(equations({"a = 1", "b = a * \\vec{n}", "f = b \\cdot \\vec{h}"}));
    Document anew{std::string(document.text().bytes())};
    ASSERT_EQ(everything_of(document.snapshot()), everything_of(anew.snapshot()))
        << "seed " << seed << ", step " << step << "\n"
        << document.text().bytes();
  }
}

TEST(Document, AnyBytesGiveAnAnswer) {
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    std::string bytes = "\\begin{equation}";
    for (int i = random() % 200; i > 0; --i) bytes += static_cast<char>(random() % (round % 2 == 0 ? 256 : 128));
    if (round % 3 == 0) bytes += "\\end{equation}";
    Document document(bytes);
    everything_of(document.snapshot());
  }
}

std::string repeated(const std::string& piece, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += piece;
  return text;
}

TEST(Document, HugeEquationsStayLinear) {
  const std::string documents[] = {
      "f = \\max(" + repeated("q,", 100'000) + "q)",
      "f = \\max(" + repeated("q q,", 60'000) + "q)",
      "f = \\max(" + repeated("\\foo{1},", 60'000) + "q)",
      "f = \\max(" + repeated("\\foo{", 60'000) + "q)",
      "f(" + repeated("p_{a},", 60'000) + "p) = p \\times \\vec{n}",
      "f_{" + repeated("long", 100'000) + "} = \\max(" + repeated("q,", 100'000) + "q)",
      "f = " + repeated("2 a ", 100'000),
  };
  for (const std::string& body : documents) {
    Document document(equations({body}));
    const auto all = document.snapshot().diagnostics();
    EXPECT_GE(all.size(), 1u);
    EXPECT_LE(all.size(), kMaxReports + 100);
    for (const Diagnostic& d : all) ASSERT_LE(message(d).size(), 1000u);
  }
}

TEST(Document, AChainOfTenThousandDefinitionsIsOrdinary) {
  Document document(ladder(10'000));
  EXPECT_TRUE(reports(document.snapshot()).empty());
  EXPECT_TRUE(document.snapshot().program());
  document.replace(find(document, "1 + 1"), "a_{9999}");
  EXPECT_EQ(reports(document.snapshot()).size(), 1u) << "one cycle";
}

}  // namespace
}  // namespace texbrdf
