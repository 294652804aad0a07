// What the macros of a document make of its equations.

#include <gtest/gtest.h>

#include <string>

#include "analysis/document.h"
#include "reports.h"
#include "syntax/print_source.h"

namespace texbrdf {
namespace {

/// All definitions as they are printed, then the codes of errors and warnings of what cannot be read.
std::string read(const Snapshot& snapshot) {
  std::string text;
  for (const Definition& definition : snapshot.definitions()) {
    const ParsedBlock& block = snapshot.parsed(definition.block);
    const DefinitionSyntax& syntax = block.definitions[definition.index_in_block];
    text += (text.empty() ? "" : " | ") + (syntax.readable ? print_source(block, syntax) : "?");
  }
  for (uint32_t block = 0; block < snapshot.blocks().size(); ++block) {
    for (const Diagnostic& d : snapshot.parsed({block}).diagnostics) {
      if (d.severity < Severity::Information) text += " " + code_name(d.code);
    }
  }
  return text;
}

std::string read(const std::string& text) {
  return read(Document(text).snapshot());
}

struct Case {
  const char* macros;
  const char* equation;
  const char* read;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.macros << " in " << c.equation;
}

class Macros : public testing::TestWithParam<Case> {};

TEST_P(Macros, stand_for_their_text) {
  const Case& c = GetParam();
  const std::string equation = "\\begin{equation}" + std::string(c.equation) + "\\end{equation}\n";
  EXPECT_EQ(read(c.macros + ("\n" + equation)), c.read);
  EXPECT_EQ(read(equation + c.macros), c.read) << "a macro holds in the whole document";
}

constexpr Case kForms[] = {
    {"\\newcommand{\\NoV}{(\\mathbf{n}\\cdot\\mathbf v)}", "f = \\NoV", "f=(\\mathbf{n}*\\mathbf v)"},
    {"\\newcommand\\x{2}", "f = \\x", "f=2"},
    {"\\newcommand*{\\x}{2}", "f = \\x", "f=2"},
    {"\\renewcommand{ \\x } { 2 }", "f = \\x", "f=2"},
    {"\\newcommand{\\x}\\alpha", "f = \\x", "f=\\alpha"},
    {"\\providecommand{\\x}{2}", "f = \\x", "f=2"},
    {"\\newcommand{\\x}{1}\\providecommand{\\x}{2}", "f = \\x", "f=1"},
    {"\\newcommand{\\x}{1}\\renewcommand{\\x}{2}", "f = \\x", "f=2"},
    {"\\def\\half{\\frac12}", "f = \\half", "f=(1/2)"},
    {"\\def\\q#1#2{#2-#1}", "f = \\q a{b}", "f=(b-a)"},
    {"\\DeclareMathOperator{\\sch}{Schlick}", "f = \\sch(u)", "f=\\operatorname{Schlick}(u)"},
    {"\\DeclareMathOperator*{\\sch}{Schlick}", "f = \\sch", "f=\\operatorname{Schlick}"},
    {"\\DeclarePairedDelimiter{\\abs}{\\lvert}{\\rvert}", "f = \\abs{x} + \\abs*{y}", "f=(|x|+|y|)"},
    {"\\let\\phi\\varphi", "f = \\phi", "f=\\varphi"},
    {"\\let\\old=\\phi \\renewcommand{\\phi}{\\old_x}", "f = \\phi", "f=\\phi_x"},
    {"\\let\\a\\alpha \\let\\alpha\\beta \\let\\beta\\a", "f = \\alpha - \\beta", "f=(\\beta-\\alpha)"},
    {"\\renewcommand{\\vec}[1]{\\mathbf{#1}}", "f = \\vec n", "f=\\mathbf{n}"},
    {"\\newcommand{\\x}{\\ensuremath{\\alpha}\\xspace}", "f = \\x", "f=\\alpha"},
    {"$$\\newcommand{\\x}{2}$$", "f = \\x", "f=2"},
    {"$\\newcommand{\\x}{2}$", "f = \\x", "f=2"},
    {"\\[\\def\\x{2}\\]", "f = \\x", "f=2"},
    {"\\newcommand{\\be}{\\begin{equation}}\\newcommand{\\x}{2}", "f = \\x", "f=2"},
    {"% \\newcommand{\\x}{2}", "f = \\x", "f=\\x"},
    {"\\begin{verbatim}\\newcommand{\\x}{2}\\end{verbatim}", "f = \\x", "f=\\x"},
    {"\\newcommand{\\x}{2 % two\n  + 1}", "f = \\x", "f=(2+1)"},
};
INSTANTIATE_TEST_SUITE_P(Forms, Macros, testing::ValuesIn(kForms));

constexpr Case kArguments[] = {
    {"\\newcommand{\\sq}[1]{#1^2}", "f = \\sq{x} y", "f=((x^2)*y)"},
    {"\\newcommand{\\sq}[1]{#1^2}", "f = \\sq{x}y", "f=((x^2)*y)"},
    {"\\newcommand{\\half}[1]{\\frac{#1}{2}}", "f = \\half x", "f=(x/2)"},
    {"\\newcommand{\\half}[1]{\\frac{#1}{2}}", "f = \\half{x + 1}", "f=((x+1)/2)"},
    {"\\newcommand{\\half}[1]{\\frac{#1}{2}}", "f = \\half\\alpha", "f=(\\alpha/2)"},
    {"\\newcommand{\\abs}[1]{\\left|#1\\right|}", "f = \\abs{x - 1}", "f=|(x-1)|"},
    {"\\newcommand{\\brdf}[1]{f_{\\text{#1}}}", "\\brdf{spec} = 1", "f_{\\text{spec}}=1"},
    {"\\newcommand{\\dotp}[2]{(#1\\cdot #2)}\\newcommand{\\n}{\\mathbf{n}}", "f = \\dotp{\\n}{\\omega_i}",
     "f=(\\mathbf{n}*\\omega_i)"},
    {"\\newcommand{\\sq}[1]{#1^2}\\newcommand{\\d}[1]{(1-#1)}", "f = \\sq{\\d{\\sq{x}}}", "f=((1-(x^2))^2)"},
    {"\\newcommand{\\root}[2][2]{\\sqrt[#1]{#2}}", "f = \\root{x} + \\root[3]{y}", "f=(\\sqrt[2](x)+\\sqrt[3](y))"},
    {"\\newcommand{\\q}[1]{\\frac{#1}{\\|#1\\|}}", "f = \\q{\\vec n}", "f=(\\vec n/|\\vec n|)"},
    {"\\newcommand{\\avg}{\\mean}\\newcommand{\\mean}[1]{(#1/2)}", "f = \\avg{x}", "f=(x/2)"},
    {"\\newcommand{\\bold}[1]{\\mathbf#1}", "f = \\bold n", "f=\\mathbf n"},
};
INSTANTIATE_TEST_SUITE_P(Arguments, Macros, testing::ValuesIn(kArguments));

constexpr Case kPlaces[] = {
    {"\\newcommand{\\lp}{\\left(}\\newcommand{\\rp}{\\right)}", "f = \\lp x + 1\\rp y", "f=((x+1)*y)"},
    {"\\newcommand{\\dotp}{\\cdot}", "f = x \\dotp y", "f=(x*y)"},
    {"\\renewcommand{\\aa}{\\alpha^2}", "f = \\frac\\aa\\pi + \\sqrt\\aa",
     "f=(((\\alpha^2)/\\pi)+\\sqrt((\\alpha^2)))"},
    {"\\renewcommand{\\aa}{\\alpha^2}", "f = \\frac{1}\\aa", "f=(1/(\\alpha^2))"},
    {"\\renewcommand{\\aa}{\\alpha^2}", "f = \\frac1\\aa", "f=(1/(\\alpha^2))"},
    {"\\renewcommand{\\aa}{\\alpha^2}", "f = \\aa2", "? E3012"},
    {"\\newcommand{\\i}{\\omega_i}", "f(\\i) = \\i", "f(\\omega_i)=\\omega_i"},
    {"\\newcommand{\\p}{2y}", "f = x^\\p", "f=(x^(2*y))"},
    {"\\newcommand{\\s}{\\text{spec}}", "f_\\s = 1", "f_{\\text{spec}}=1"},
    {"\\newcommand{\\F}{F_0}", "f = a\\F b", "f=((a*F_0)*b)"},
    {"\\newcommand{\\eq}{a = 1 \\\\ b = 2}", "\\begin{aligned}\\eq\\end{aligned}", "a=1 | b=2"},
    {"", "\\newcommand{\\x}{2} f = \\x", "f=2"},
    {"", "\\foo = 3", "\\foo=3"},
};
INSTANTIATE_TEST_SUITE_P(Places, Macros, testing::ValuesIn(kPlaces));

constexpr Case kProblems[] = {
    {"\\newcommand{\\x}{1 + \\x}", "f = \\x", "? E1010"},
    {"\\newcommand{\\x}{\\y}\\newcommand{\\y}{\\x}", "f = \\x", "? E1010"},
    {"\\newcommand{\\sq}[1]{#1^2}", "f = \\sq", "? E1011"},
    {"\\def\\a#1{#1{#1}}", "f = \\a\\a", "? E1012"},
    {"\\def\\a{\\b\\b\\b\\b}\\def\\b{\\c\\c\\c\\c}\\def\\c{\\d\\d\\d\\d}\\def\\d{\\e\\e\\e\\e}\\def\\e{\\g\\g\\g\\g}"
     "\\def\\g{\\h\\h\\h\\h}\\def\\h{\\,\\,\\,\\,}",
     "f = \\a", "? E1012"},
    // What cannot be read is no definition, and no error.
    {"\\newcommand{\\x}[", "f = 1", "f=1"},
    {"\\newcommand{\\x}{", "f = 1", "f=1"},
    {"\\def\\x#1.{#1}", "f = 1", "f=1"},
    {"\\newcommand{\\x}{1 + \\x}", "f = 1", "f=1"},
};
INSTANTIATE_TEST_SUITE_P(Problems, Macros, testing::ValuesIn(kProblems));

std::string where(const Snapshot& snapshot, Location location) {
  return snapshot.text().slice(snapshot.absolute(location));
}

TEST(MacroReports, PointAtTheUseAndTellTheDefinition) {
  Document document("\\newcommand{\\x}{q + 1}\n\\begin{equation}f = 2\\x\\end{equation}");
  const std::vector<Diagnostic>& all = document.snapshot().diagnostics();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].code, Code::UndefinedName);
  EXPECT_EQ(where(document.snapshot(), all[0].where), "\\x");
  ASSERT_EQ(all[0].related.size(), 1u);
  EXPECT_EQ(document.snapshot().absolute(all[0].related[0].where), (Span{12, 14}));
  EXPECT_TRUE(all[0].fixes.empty());
}

TEST(MacroReports, PointAtAnArgumentWhereItIsWrong) {
  Document document("\\newcommand{\\sq}[1]{#1^2}\n\\begin{equation}f = \\sq{1 + q}\\end{equation}");
  EXPECT_EQ(test::reports(document.snapshot(), Severity::Error),
            std::vector<std::string>{"E3001 2:29 [q] undefined name `q` in the definition of `f`"});
}

TEST(MacroReports, AnEditOfADefinitionReadsOnlyItsUsesAgain) {
  std::string text = "\\newcommand{\\x}{2}\n\\newcommand{\\y}{\\x}\n";
  for (int i = 0; i < 50; ++i) text += "\\begin{equation}a_{" + std::to_string(i) + "} = 1\\end{equation}\n";
  text += "\\begin{equation}b = \\x\\end{equation}\n\\begin{equation}c = \\y\\end{equation}\n";
  Document document(text);
  document.snapshot();
  document.replace({16, 17}, "3");
  const Snapshot& snapshot = document.snapshot();
  EXPECT_EQ(snapshot.counters().blocks_parsed, 2u);
  EXPECT_EQ(read(snapshot).substr(read(snapshot).find("b=")), "b=3 | c=3");
  document.replace({0, 0}, "Words. ");
  EXPECT_EQ(document.snapshot().counters().blocks_parsed, 0u);
  document.replace({7, 26}, "");
  EXPECT_EQ(document.snapshot().counters().blocks_parsed, 2u);
  EXPECT_EQ(read(document.snapshot()).substr(read(document.snapshot()).find("b=")), "b=\\x | c=\\x");
}

TEST(MacroReports, AreFoundAtTheirNames) {
  Document document("\\newcommand{\\sq}[1]{#1^2}\n\\begin{equation}f = \\sq{x}\\end{equation}");
  const Snapshot& snapshot = document.snapshot();
  const auto use = snapshot.macro_at(47);
  ASSERT_TRUE(use);
  EXPECT_EQ(use->name, "sq");
  EXPECT_EQ(use->whole, (Span{46, 52}));
  EXPECT_EQ(use->definition, (Span{0, 25}));
  EXPECT_FALSE(snapshot.macro_at(50));
  EXPECT_EQ(snapshot.places_of_macro("sq"), (std::vector<Span>{{12, 15}, {46, 49}}));
  const auto argument = snapshot.occurrence_at(50);
  ASSERT_TRUE(argument);
  EXPECT_EQ(argument->span, (Span{50, 51}));
}

TEST(MacroReports, StandForTheSameInEveryFileOfAProject) {
  Document document("\\input{macros}\n\\begin{equation}f = \\x\\end{equation}\n");
  document.insert_file({1}, SourceText("\\newcommand{\\x}{2}"));
  EXPECT_EQ(read(document.snapshot()), "f=2");
  document.remove_file({1});
  EXPECT_EQ(read(document.snapshot()), "f=\\x");
}

}  // namespace
}  // namespace texbrdf
