#include "features/numeric_diagnostics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "analysis/document.h"

namespace texbrdf::features {
namespace {

/// "E4009 warning [underlined]" of what is found by computing, and of redefined conventions.
std::vector<std::string> computed(const std::string& text) {
  Document document(text);
  const Snapshot& snapshot = document.snapshot();
  std::vector<std::string> found;
  for (const Diagnostic& diagnostic : all_diagnostics(snapshot)) {
    if (diagnostic.code != Code::RestatementDiffers && diagnostic.code != Code::ConventionRedefined) continue;
    found.push_back(code_name(diagnostic.code) + " " + std::string(severity_name(diagnostic.severity)) + " [" +
                    snapshot.text().slice(snapshot.absolute(diagnostic.where)) + "]");
  }
  return found;
}

using Found = std::vector<std::string>;

TEST(NumericDiagnostics, EqualSidesOfAChainAreNoNews) {
  EXPECT_EQ(computed("$$f = (1 + x)^2 = 1 + 2x + x^2 = x^2 + 1 + 2x, \\quad x = 0.5$$"), Found{});
}

TEST(NumericDiagnostics, ASideThatDiffersIsTold) {
  EXPECT_EQ(computed("$$f = (1 + x)^2 = 1 + 2x + x^2 = x(x + 1), \\quad x = 0.5$$"), Found{"E4009 warning [x(x + 1)]"});
}

TEST(NumericDiagnostics, FunctionsAreComparedWithSomeArguments) {
  const std::string use = " and $$f = F(0.5) + F(0.25)$$ with $r = (0.1, 0.2, 0.3)$";
  EXPECT_EQ(computed("$$F(x) = r + (1 - r)x = x + r(1 - x)$$" + use), Found{});
  EXPECT_EQ(computed("$$F(x) = r + (1 - r)x = x - r(1 - x)$$" + use), Found{"E4009 warning [x - r(1 - x)]"});
}

TEST(NumericDiagnostics, DirectionsAreTriedUntilOneShowsTheDifference) {
  EXPECT_EQ(computed("$$f = \\max(\\omega_i \\cdot \\omega_o, 0) = \\omega_i \\cdot \\omega_o$$"),
            Found{"E4009 warning [\\omega_i \\cdot \\omega_o]"});
}

TEST(NumericDiagnostics, AnApproximationMayDiffer) {
  EXPECT_EQ(computed("$$f = \\pi \\approx 3.14 < 4$$"), Found{});
}

TEST(NumericDiagnostics, WhatTheRootDoesNotNeedIsAHint) {
  EXPECT_EQ(computed("$$f = 1$$ $$a = 1 = 2$$"), Found{"E4009 hint [2]"});
}

TEST(NumericDiagnostics, WhatCannotBeComputedIsLeftAlone) {
  EXPECT_EQ(computed("$$f = 1 = q = \\sum = ( = L_o$$"), Found{});
}

TEST(NumericDiagnostics, AConventionDefinedAsWhatItIsIsNoNews) {
  const std::string use = " $$f = \\theta_h + \\omega_i \\cdot \\vec{h}$$";
  EXPECT_EQ(computed("$$\\vec{h} = \\frac{\\omega_i + \\omega_o}{\\|\\omega_i + \\omega_o\\|}$$" + use), Found{});
  EXPECT_EQ(computed("$$\\vec{h} = \\frac{\\omega_i - \\omega_o}{\\|\\omega_i - \\omega_o\\|}$$" + use),
            Found{"E3008 hint [\\vec{h}]"});
}

/// The codes of all that is computed, whatever its severity.
std::vector<std::string> codes(const std::string& text) {
  Document document(text);
  std::vector<std::string> found;
  for (const Diagnostic& diagnostic : all_diagnostics(document.snapshot())) {
    const bool is_computed = diagnostic.code == Code::RestatementDiffers || diagnostic.code == Code::InexactIntegral;
    if (is_computed) found.push_back(code_name(diagnostic.code));
  }
  return found;
}

TEST(NumericDiagnostics, AreSilencedByInstructions) {
  const std::string equation = "\\begin{equation}f = \\int_0^1 \\sqrt{|x - 0.3|}\\,dx = 7\\end{equation}\n";
  EXPECT_EQ(codes(equation), (Found{"E4044", "E4009"}));
  EXPECT_EQ(codes("% texbrdf: allow E4044\n" + equation), Found{"E4009"});
  EXPECT_EQ(codes("% texbrdf: allow E4009\n" + equation), Found{"E4044"});
  EXPECT_EQ(codes("% texbrdf: allow E4044\n% texbrdf: allow E4009\n\nText.\n" + equation), Found{});
  const std::string elsewhere = "% texbrdf: allow E4044\n\\begin{equation}a = 1\\end{equation}\n";
  EXPECT_EQ(codes(elsewhere + equation), (Found{"E4044", "E4009"}));
}

NumericFindings findings_of(const Snapshot& snapshot) {
  return *find_numerically(snapshot, numeric_questions(snapshot));
}

TEST(NumericFindings, HoldUntilSomethingChangesThatTheyDependOn) {
  const std::string text = "$$f = a + 1 = 3 + q$$ $$a = 2$$ $$q = b$$ $$b = 0$$ $$other = 1$$ text";
  Document document(text);
  const NumericFindings known = findings_of(document.snapshot());
  const auto holds_after = [&](const std::string& old, const std::string& replacement) {
    Document edited(text);
    const NumericFindings before = findings_of(edited.snapshot());
    const auto at = static_cast<uint32_t>(text.find(old));
    edited.replace({at, at + static_cast<uint32_t>(old.size())}, replacement);
    const Snapshot& now = edited.snapshot();
    return before.hold_for(now, numeric_questions(now));
  };
  EXPECT_TRUE(known.is_silent());
  EXPECT_TRUE(holds_after("text", "$$new = 7$$"));
  EXPECT_TRUE(holds_after("other = 1", "other = 1 + 1"));
  EXPECT_TRUE(holds_after("$$f", "$$new = 7$$ $$f"));
  EXPECT_FALSE(holds_after("a = 2", "a = 3"));
  EXPECT_FALSE(holds_after("b = 0", "b = 1"));  // by what a chain says once more
  EXPECT_FALSE(holds_after("$$b = 0$$", ""));
  EXPECT_FALSE(holds_after("3 + q", "3 + q = 4"));
}

TEST(NumericFindings, OfIntegralsHoldUntilOneOfTheirDefinitionsChanges) {
  const std::string text = "$$f = E$$ $$E = \\int_0^1 \\sqrt{|x - m|}\\,dx$$ $$m = 0.3$$ $$other = 1$$";
  Document document(text);
  const NumericFindings known = findings_of(document.snapshot());
  EXPECT_FALSE(known.is_silent());
  document.replace({static_cast<uint32_t>(text.size()) - 3, static_cast<uint32_t>(text.size()) - 2}, "2");
  EXPECT_TRUE(known.hold_for(document.snapshot(), numeric_questions(document.snapshot())));
  const auto digit = static_cast<uint32_t>(text.find("0.3"));
  document.replace({digit, digit + 3}, "0.4");
  EXPECT_FALSE(known.hold_for(document.snapshot(), numeric_questions(document.snapshot())));
}

TEST(NumericFindings, AreNothingWhenTheyAreStopped) {
  Document document("$$f = \\int_0^1 x^2\\,dx$$");
  std::stop_source stop;
  stop.request_stop();
  const NumericQuestions questions = numeric_questions(document.snapshot());
  EXPECT_FALSE(find_numerically(document.snapshot(), questions, stop.get_token()));
  EXPECT_TRUE(find_numerically(document.snapshot(), questions));
}

TEST(NumericDiagnostics, ManyChainsTakeBoundedTime) {
  std::string text = "$$f = 1$$";
  for (int i = 0; i < 5000; ++i) text += "$$a_{" + std::to_string(i) + "} = 1 = 2$$\n";
  EXPECT_LE(computed(text).size(), 64U);
}

}  // namespace
}  // namespace texbrdf::features
