#include "features/completion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/document.h"
#include "features/completion_commands.h"
#include "features/completion_text.h"
#include "semantics/name_traits.h"
#include "syntax/control_words.h"

namespace texbrdf::features {
namespace {

constexpr std::string_view kModel =
    "\\begin{equation}\\rho_d = 0.5\\end{equation}\n"
    "\\begin{equation}\\vec{c} = \\vec{1, 0, 0}\\end{equation}\n"
    "\\begin{equation}\\text{cook\\_t} = 2\\end{equation}\n"
    "\\begin{equation}\\phi_{\\text{diff}} = 3\\end{equation}\n"
    "\\begin{equation}g(m, \\vec{t}) = m * \\vec{t}\\end{equation}\n";

struct Asked {
  Completions found;
  std::string replaced;  ///< text in the range
};

/// What is proposed at the `@` of an equation that stands behind the model.
Asked ask(std::string_view source, bool snippets = false, std::string_view before = kModel) {
  std::string text = std::string(before) + std::string(source);
  const std::size_t at = text.find('@');
  text.erase(at, 1);
  Document document(text);
  NameIndex index;
  const Snapshot& snapshot = document.snapshot();
  Asked asked{complete(snapshot, static_cast<uint32_t>(at), index, {.snippets = snippets}), {}};
  asked.replaced = snapshot.text().slice(asked.found.replaced);
  return asked;
}

std::string equation(std::string_view content) {
  return "\\begin{equation}" + std::string(content) + "\\end{equation}\n";
}

std::string labels(const Completions& found) {
  std::string text;
  for (const CompletionItem& item : found.items) text += (text.empty() ? "" : " ") + item.label;
  return text;
}

/// `[replaced] proposals`, or `-` where nothing is ours.
std::string proposals(std::string_view source) {
  const Asked asked = ask(source);
  return asked.found.in_math ? "[" + asked.replaced + "] " + labels(asked.found) : "-";
}

const CompletionItem* find(const Completions& found, std::string_view label) {
  const auto item = std::ranges::find(found.items, label, &CompletionItem::label);
  return item == found.items.end() ? nullptr : &*item;
}

TEST(Completion, IsGivenInsideEquationsOnly) {
  EXPECT_EQ(proposals("prose \\rh@ and " + equation("f = 1")), "-");
  EXPECT_EQ(proposals(equation("f = 1") + "\\rh@"), "-");
  EXPECT_EQ(proposals("@" + equation("f = 1")), "-");
  EXPECT_EQ(proposals("\\begin{equation}f = 1 % \\rh@\n\\end{equation}"), "-");
  EXPECT_EQ(proposals("\\begin{equ@ation}f = 1\\end{equation}"), "-");
  EXPECT_EQ(proposals("\\begin{equation}f = 1\\en@d{equation}"), "-");
  EXPECT_EQ(proposals(equation("f = \\rh@")), "[\\rh] \\rho_d");
}

TEST(Completion, LeavesToOthersWhatTheLanguageDoesNotRead) {
  for (const char* content : {"f = 1 \\label{eq:r@}", "f = 1 \\label{eq:r@", "\\label{r@} f = 1", "f = 1 \\tag*{r@}",
                              "f = \\cite{r@}", "f = \\cite{r@", "f = \\begin{r@", "f = \\foo{\\frac{r@}{2}}"}) {
    EXPECT_EQ(proposals(equation(content)), "-") << content;
  }
}

TEST(Completion, HasNothingForNumbers) {
  for (const char* content : {"f = 1@", "f = 0.@", "f = 0.5@", "f = 1e-3@", "f = 1@2"}) {
    EXPECT_EQ(proposals(equation(content)), "-") << content;
  }
}

TEST(Completion, FindsNamesByHowTheyBegin) {
  EXPECT_EQ(proposals(equation("f = \\rho@")), "[\\rho] \\rho_d");
  EXPECT_EQ(proposals(equation("f = \\rho_@")), "[\\rho_] \\rho_d");
  EXPECT_EQ(proposals(equation("f = \\rho_{d@}")), "[\\rho_{d}] \\rho_d");
  EXPECT_EQ(proposals(equation("f = rh@")), "[rh] \\rho_d");
  EXPECT_EQ(proposals(equation("f = coo@")), "[coo] \\text{cook\\_t}");
  EXPECT_EQ(proposals(equation("f = \\text{coo@}")), "[\\text{coo}] \\text{cook\\_t}");
  EXPECT_EQ(proposals(equation("f = \\text{cook\\_@")), "[\\text{cook\\_] \\text{cook\\_t}");
  EXPECT_EQ(proposals(equation("f = \\phi_{\\text{d@}}")), "[\\phi_{\\text{d}}] \\phi_{diff}");
  EXPECT_EQ(proposals(equation("f = \\mathbf{c@}")), "[\\mathbf{c}] \\mathbf{c}");
  EXPECT_EQ(proposals(equation("f = \\phi_{di@}")), "[\\phi_{di}] \\phi_{diff}");
  EXPECT_EQ(proposals(equation("f = \\mathrm{coo@}")), "[\\mathrm{coo}] \\text{cook\\_t}");
  EXPECT_EQ(proposals(equation("f = \\theta_@")), "[\\theta_] \\theta_i \\theta_o \\theta_h \\theta_d");
  EXPECT_EQ(proposals(equation("f = nowhere@")), "[nowhere] ");
}

TEST(Completion, InsideVecFindsVectorsByName) {
  EXPECT_EQ(proposals(equation("f = \\vec{@}")),
            "[\\vec{}] \\vec{c} \\vec{\\omega_i} \\vec{\\omega_o} \\vec{n} \\vec{h}");
  EXPECT_EQ(proposals(equation("f = \\vec{@")),
            "[\\vec{] \\vec{c} \\vec{\\omega_i} \\vec{\\omega_o} \\vec{n} \\vec{h}");
  EXPECT_EQ(proposals(equation("f = 2 * \\vec{\\om@}")), "[\\vec{\\om}] \\vec{\\omega_i} \\vec{\\omega_o}");
  EXPECT_EQ(proposals(equation("f = \\vec{om@")), "[\\vec{om] \\vec{\\omega_i} \\vec{\\omega_o}");
}

TEST(Completion, ReplacesUpToTheCaretAndTheClosersOfItsBraces) {
  EXPECT_EQ(proposals(equation("f = (\\rh@x)")), "[\\rh] \\rho_d");
  EXPECT_EQ(proposals(equation("f = \\frac{\\rh@}{2}")), "[\\rh] \\rho_d");
  EXPECT_EQ(proposals(equation("f = \\frac{\\vec{c@}}{2}")), "[\\vec{c}] \\vec{c}");
}

TEST(Completion, WorksInBrokenEquations) {
  for (const char* content : {"f = (1 + \\rh@", "f = 1 + * \\rh@", "f = \\frac{\\rh@", "f = 2x \\rh@", "f = ) \\rh@",
                              "f = ; \\rh@", "1 + 2 = \\rh@", "f = a = \\rh@"}) {
    EXPECT_EQ(proposals(equation(content)), "[\\rh] \\rho_d") << content;
  }
  EXPECT_EQ(proposals("\\begin{equation}\n f = \\rh@\n\nprose"), "[\\rh] \\rho_d");
  EXPECT_EQ(proposals("\\begin{equation}\n f = \\rh@"), "[\\rh] \\rho_d");
}

TEST(Completion, AfterABackslashHasNamesAndCommands) {
  const Completions found = ask(equation("f = \\@\n")).found;
  for (const char* label :
       {"\\rho_d", "\\vec{c}", "\\omega_i", "\\vec{n}", "\\pi", "\\frac", "\\sin", "\\max", "\\cdot", "\\times"}) {
    EXPECT_NE(find(found, label), nullptr) << label;
  }
  EXPECT_EQ(find(found, "g"), nullptr);        // no backslash
  EXPECT_EQ(find(found, "\\alpha"), nullptr);  // nothing that exists
}

TEST(Completion, ProposesParametersFirstAndNotTheNameItself) {
  const Completions found = ask(equation("h(\\rho_d, \\omega_i) = @")).found;
  ASSERT_GE(found.items.size(), 2u);
  EXPECT_EQ(found.items[0].label, "\\rho_d");
  EXPECT_EQ(found.items[0].kind, CompletionKind::Parameter);
  EXPECT_EQ(found.items[1].label, "\\omega_i");
  EXPECT_EQ(found.function, "h");
  EXPECT_EQ(std::ranges::count(found.items, "\\rho_d", &CompletionItem::label), 1);
  EXPECT_EQ(std::ranges::count(found.items, "\\omega_i", &CompletionItem::label), 1);
  EXPECT_EQ(find(found, "h"), nullptr);
}

TEST(Completion, AConventionThatIsDefinedAnewIsADefinition) {
  const Completions found = ask(equation("\\theta_i = 1") + equation("f = \\theta_@")).found;
  ASSERT_NE(find(found, "\\theta_i"), nullptr);
  EXPECT_EQ(find(found, "\\theta_i")->kind, CompletionKind::Definition);
  EXPECT_EQ(std::ranges::count(found.items, "\\theta_i", &CompletionItem::label), 1);
}

TEST(Completion, ALeftSideIsMadeOfLetters) {
  EXPECT_EQ(proposals(equation("\\rh@")), "[\\rh] \\rho");
  EXPECT_EQ(proposals(equation("\\rho_{\\alp@}")), "[\\alp] \\alpha");
  EXPECT_EQ(proposals(equation("\\ve@ = 1")), "[\\ve] \\vec");
  EXPECT_EQ(proposals(equation("k(\\omega@) = 1")), "[\\omega] \\omega_i \\omega_o \\omega \\Omega");
}

/// The fit of \rho_d (ℝ) and \vec{c} (ℝ³) at a place: `.` fits, `x` does not.
std::string fits(std::string_view content) {
  const Completions found = ask(equation(content)).found;
  std::string text;
  for (const char* label : {"\\rho_d", "\\vec{c}"}) {
    const CompletionItem* item = find(found, label);
    text += item == nullptr ? '?' : item->fit == Fit::Good ? '.' : 'x';
  }
  return text;
}

TEST(Completion, RanksByTheTypeThatThePlaceDemands) {
  EXPECT_EQ(fits("f = @"), "..");
  EXPECT_EQ(fits("f = 2 * @"), "..");
  EXPECT_EQ(fits("f = \\vec{n} + @"), "x.");
  EXPECT_EQ(fits("f = 1 - @"), ".x");
  EXPECT_EQ(fits("f = -@"), "..");
  EXPECT_EQ(fits("f = \\vec{n} - (@"), "x.");
  EXPECT_EQ(fits("f = \\vec{n} \\times @"), "x.");
  EXPECT_EQ(fits("f = \\vec{n} / @"), ".x");
  EXPECT_EQ(fits("f = \\exp(@"), ".x");
  EXPECT_EQ(fits("f = \\exp @"), ".x");
  EXPECT_EQ(fits("f = \\sqrt[3]{@}"), ".x");
  EXPECT_EQ(fits("f = \\max(1, @"), ".x");
  EXPECT_EQ(fits("f = 2^@"), ".x");
  EXPECT_EQ(fits("f = 2^{@}"), ".x");
  EXPECT_EQ(fits("f = \\frac{@}{2}"), "..");
  EXPECT_EQ(fits("f = \\vec{n} + \\frac{@}{2}"), "x.");
  EXPECT_EQ(fits("f = \\frac{\\vec{n}}{@}"), ".x");
  EXPECT_EQ(fits("f = g(@"), ".x");
  EXPECT_EQ(fits("f = g(1, @"), "x.");
  EXPECT_EQ(fits("f = g(\\max(1, 2), @)"), "x.");
  EXPECT_EQ(fits("f = g(1, 2, @)"), "..");
  EXPECT_EQ(fits("f = nowhere(@)"), "..");
}

TEST(Completion, WhatFitsComesFirst) {
  const Completions found = ask(equation("f = \\vec{n} \\times @")).found;
  ASSERT_FALSE(found.items.empty());
  EXPECT_EQ(found.items.front().label, "\\vec{c}");
  EXPECT_TRUE(std::ranges::is_sorted(found.items, {}, &CompletionItem::fit));
}

TEST(Completion, SaysTypes) {
  const Completions found = ask(equation("k(x) = @")).found;
  EXPECT_EQ(find(found, "g")->detail, "ℝ × ℝ³ → ℝ³");
  EXPECT_EQ(find(found, "\\rho_d")->detail, "ℝ");
  EXPECT_EQ(find(found, "\\vec{n}")->detail, "ℝ³");
}

TEST(Completion, HasSnippetsOnlyWhereTheClientTakesThem) {
  const Completions plain = ask(equation("f = @")).found;
  EXPECT_TRUE(std::ranges::none_of(plain.items, &CompletionItem::is_snippet));
  EXPECT_EQ(find(plain, "g")->new_text, "g");
  EXPECT_EQ(find(plain, "\\frac")->new_text, "\\frac");

  const Completions rich = ask(equation("f = @"), true).found;
  EXPECT_EQ(find(rich, "g")->new_text, "g(${1:m}, ${2:\\\\vec{t\\}})");
  EXPECT_EQ(find(rich, "\\frac{…}{…}")->new_text, "\\\\frac{$1}{$2}");
  EXPECT_EQ(find(rich, "\\frac{…}{…}")->filter, "\\frac");
  EXPECT_EQ(find(rich, "\\vec{…, …, …}")->new_text, "\\\\vec{$1, $2, $3}");
  EXPECT_FALSE(find(rich, "\\rho_d")->is_snippet);
}

TEST(Completion, LeavesArgumentsThatStandThere) {
  EXPECT_EQ(find(ask(equation("f = @(1, \\vec{n})"), true).found, "g")->new_text, "g");
}

TEST(Completion, TheFilterStartsWithWhatIsTyped) {
  const auto filter = [](std::string_view content, std::string_view label) {
    const Completions found = ask(equation(content)).found;
    const CompletionItem* item = find(found, label);
    return item == nullptr ? "nothing" : item->filter;
  };
  EXPECT_EQ(filter("f = \\rh@", "\\rho_d"), "");
  EXPECT_EQ(filter("f = rh@", "\\rho_d"), "rho_d");
  EXPECT_EQ(filter("f = RH@", "\\rho_d"), "RHo_d");
  EXPECT_EQ(filter("f = \\rho_{@", "\\rho_d"), "\\rho_{d");
  EXPECT_EQ(filter("f = \\vec{om@", "\\vec{\\omega_i}"), "\\vec{omega_i");
}

TEST(Completion, OfManyNamesProposesTheNearestAndSaysThatThereAreMore) {
  std::string before;
  for (int i = 0; i < 2000; ++i) before += equation("a_{" + std::to_string(i) + "} = 1");
  const std::string behind = equation("a_{9000} = 1");
  const Asked some = ask(equation("f = a@") + behind, false, before);
  EXPECT_FALSE(some.found.complete);
  EXPECT_EQ(std::ranges::count(some.found.items, CompletionKind::Definition, &CompletionItem::kind),
            static_cast<std::ptrdiff_t>(kMostCompletions));
  EXPECT_NE(find(some.found, "a_{1999}"), nullptr);
  EXPECT_NE(find(some.found, "a_{9000}"), nullptr);
  EXPECT_EQ(std::ranges::count(some.found.items, "a_{1999}", &CompletionItem::label), 1);

  const Asked few = ask(equation("f = a_{199@}") + behind, false, before);
  EXPECT_TRUE(few.found.complete);
  EXPECT_EQ(few.found.items.size(), 11u);
  EXPECT_EQ(few.found.items.front().label, "a_{199}");
}

TEST(Completion, TheIndexFollowsEdits) {
  Document document(equation("qa = 1") + equation("f = q"));
  NameIndex index;
  const auto names = [&] {
    const auto at = static_cast<uint32_t>(document.text().size() - std::string_view("\\end{equation}\n").size());
    return labels(complete(document.snapshot(), at, index, {}));
  };
  EXPECT_EQ(names(), "qa");
  document.replace({0, 0}, equation("qb = 1"));
  EXPECT_EQ(names(), "qa qb");
  document.replace({0, static_cast<uint32_t>(equation("qb = 1").size())}, "");
  EXPECT_EQ(names(), "qa");
  Document other(equation("qz = 1") + equation("f = q"));
  const auto at = static_cast<uint32_t>(other.text().size() - std::string_view("\\end{equation}\n").size());
  EXPECT_EQ(labels(complete(other.snapshot(), at, index, {})), "qz");
}

TEST(Completion, DocumentsItsProposals) {
  Document document(std::string(kModel) + equation("h(x, \\omega_i) = x"));
  const Snapshot& snapshot = document.snapshot();
  const auto text = [&](CompletionKind kind, std::string_view label, std::string_view function) {
    return describe_completion(snapshot, kind, label, function, Markup::PlainText);
  };
  EXPECT_EQ(text(CompletionKind::Definition, "\\rho_d", ""),
            "\\rho_d: ℝ\n\n\\rho_d = 0.5\n\nvalue 0.5 · defined on line 1");
  EXPECT_EQ(text(CompletionKind::Parameter, "x", "h"), "x: ℝ\n\nparameter of h");
  EXPECT_EQ(text(CompletionKind::Parameter, "y", "h"), "");
  EXPECT_EQ(text(CompletionKind::Convention, "\\theta_i", "h"),
            "\\theta_i: ℝ = arccos(N·L)\n\npolar angle of the incident direction\n\nhere of the parameter \\omega_i\n\n"
            "a convention of the language");
  EXPECT_EQ(text(CompletionKind::Command, "\\sin", ""), "The sine of an angle in radians.");
  EXPECT_EQ(text(CompletionKind::Command, "\\max(…, …)", ""),
            "The greatest of two or more reals; of colours by component.");
  EXPECT_EQ(text(CompletionKind::Definition, "gone", ""), "");
}

TEST(CompletionCommands, AreAllThatTheLanguageHas) {
  for (const char* word : {
#define COMMAND(name, spelling, category) "\\" spelling,
#include "syntax/commands.def"
#undef COMMAND
       }) {
    EXPECT_NE(std::ranges::find(completion_commands(), word, &CompletionCommand::spelling), completion_commands().end())
        << word;
  }
  for (const CompletionCommand& command : completion_commands()) {
    const std::string_view word = command.spelling.substr(1, command.spelling.find('{') - 1);
    EXPECT_TRUE(find_control_word(word).meaning != WordMeaning::Name || is_greek_letter(word)) << command.spelling;
  }
}

TEST(CompletionText, EscapesWhatSnippetsReserve) {
  const std::string_view parameters[] = {"x", "\\text{a$b}"};
  EXPECT_EQ(call_snippet("\\text{g}", parameters), "\\\\text{g}(${1:x}, ${2:\\\\text{a\\$b\\}})");
  EXPECT_EQ(call_snippet("g", {}), "g()");
  EXPECT_EQ(command_snippet("\\left", "(#\\right)"), "\\\\left($1\\\\right)");
}

}  // namespace
}  // namespace texbrdf::features
