#include "features/rename.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "analysis/document.h"
#include "features/new_name.h"

namespace texbrdf::features {
namespace {

std::string equation(std::string_view content) {
  return "\\begin{equation}" + std::string(content) + "\\end{equation}\n";
}

/// A text with a `@` at the place that a test asks about; the mark is taken out.
struct Marked {
  explicit Marked(std::string_view source) : text(source), place(static_cast<uint32_t>(source.find('@'))) {
    text.erase(place, 1);
  }
  std::string text;
  uint32_t place;
};

std::string applied(std::string text, const std::vector<TextEdit>& edits) {
  for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit) {
    text.replace(edit->span.begin, edit->span.size(), edit->text);
  }
  return text;
}

/// The text after renaming what stands at the mark, or why that cannot be.
std::string renamed(std::string_view source, std::string_view new_name) {
  const Marked marked(source);
  Document document(marked.text);
  const auto edits = rename(document.snapshot(), marked.place, new_name);
  return edits ? applied(marked.text, *edits) : "refused: " + edits.error();
}

std::string prepared(std::string_view source) {
  const Marked marked(source);
  Document document(marked.text);
  const auto target = renamable_at(document.snapshot(), marked.place);
  if (!target) return "refused: " + target.error();
  if (!*target) return "nothing";
  EXPECT_EQ(document.text().slice((*target)->span), (*target)->text);
  return (*target)->text;
}

TEST(Rename, ADefinitionInAllItsSpellings) {
  EXPECT_EQ(renamed(equation("f = @x_{1} + 2*x_1 + g(x_ 1)") + equation("x_1 = 2") + equation("g(x) = x"), "\\rho_d"),
            equation("f = \\rho_d + 2*\\rho_d + g(\\rho_d)") + equation("\\rho_d = 2") + equation("g(x) = x"));
  EXPECT_EQ(renamed(equation("f = \\vec{c}_1*\\vec{c_1}") + equation("@\\vec{c_1} = \\vec{1, 0, 0}"), "c"),
            equation("f = c*c") + equation("c = \\vec{1, 0, 0}"));
}

TEST(Rename, SpellingsOfOneNameBecomeOneSpelling) {
  EXPECT_EQ(renamed(equation("f = @x_{1} + x_1") + equation("x_1 = 2"), "x_1"),
            equation("f = x_1 + x_1") + equation("x_1 = 2"));
}

TEST(Rename, TheParameterThatHidesAConventionInBothItsSpellings) {
  EXPECT_EQ(renamed(equation("f = g(\\vec{n})") + equation("g(@\\omega_o) = \\vec{\\omega_o}*\\omega_o"), "\\vec{v}"),
            equation("f = g(\\vec{n})") + equation("g(\\vec{v}) = \\vec{v}*\\vec{v}"));
}

TEST(Rename, AParameterStaysInItsFunction) {
  EXPECT_EQ(renamed(equation("f = x + g(x)") + equation("g(x) = x*@x") + equation("x = 1"), "y"),
            equation("f = x + g(x)") + equation("g(y) = y*y") + equation("x = 1"));
  EXPECT_EQ(renamed(equation("f = @x + g(x)") + equation("g(x) = x*x") + equation("x = 1"), "y"),
            equation("f = y + g(y)") + equation("g(x) = x*x") + equation("y = 1"));
}

TEST(Rename, AFunctionIsRenamedInItsCalls) {
  EXPECT_EQ(renamed(equation("f = g(g(1))") + equation("@g(x) = x"), "\\text{my\\_g}"),
            equation("f = \\text{my\\_g}(\\text{my\\_g}(1))") + equation("\\text{my\\_g}(x) = x"));
}

TEST(Rename, LaterDefinitionsOfTheNameGoAlong) {
  EXPECT_EQ(renamed(equation("f = a") + equation("a = 1") + equation("@a = 2"), "b"),
            equation("f = b") + equation("b = 1") + equation("b = 2"));
}

TEST(Rename, WhatWouldJoinItsNeighboursStaysApart) {
  const std::string theta = equation("\\alpha = 1");
  EXPECT_EQ(renamed(equation("f = \\cos@\\alpha") + theta, "x"), equation("f = \\cos x") + equation("x = 1"));
  EXPECT_EQ(renamed(equation("f = 2@\\alpha") + theta, "e"), equation("f = 2 e") + equation("e = 1"));
  EXPECT_EQ(renamed(equation("f = @x_1y") + equation("x_1 = 1"), "\\rho"),
            equation("f = \\rho y") + equation("\\rho = 1"));
  EXPECT_EQ(renamed(equation("f = @\\alpha2") + theta, "x_1"), equation("f = x_1 2") + equation("x_1 = 1"));
}

TEST(Rename, AnExponentOfOneSymbolGetsBraces) {
  EXPECT_EQ(renamed(equation("f = 2^@k + \\sqrt k + k^2") + equation("k = 1"), "k_1"),
            equation("f = 2^{k_1} + \\sqrt {k_1} + k_1^2") + equation("k_1 = 1"));
  EXPECT_EQ(renamed(equation("f = 2^@k") + equation("k = 1"), "\\beta"),
            equation("f = 2^\\beta") + equation("\\beta = 1"));
  EXPECT_EQ(renamed(equation("f = 2^@g(1)") + equation("g(x) = x"), "g_1"),
            equation("f = 2^g_1(1)") + equation("g_1(x) = x"));
}

TEST(Rename, RefusedForWhatTheDocumentDoesNotDefine) {
  EXPECT_EQ(renamed(equation("f = \\cos@\\theta_i"), "x"),
            "refused: `\\theta_i` is a convention of the language and keeps its name");
  EXPECT_EQ(renamed(equation("f = \\vec{@\\omega_o}*\\vec{n}"), "x"),
            "refused: `\\omega_o` is a convention of the language and keeps its name");
  EXPECT_EQ(renamed(equation("f = @zz"), "x"), "refused: nothing in this document defines `zz`");
  EXPECT_EQ(renamed(equation("f = 1 @+ 1"), "x"), "refused: no name stands here");
}

TEST(Rename, RefusedForNewNamesThatAreNone) {
  const std::string source = equation("f = @a") + equation("a = 1");
  const auto reason = [&](std::string_view name) { return renamed(source, name).substr(sizeof("refused: ") - 1); };
  EXPECT_EQ(reason(""), "the new name is empty");
  EXPECT_EQ(reason("  "), "the new name is empty");
  const std::vector<std::string> no_names = {"2",
                                             "2x",
                                             "a b",
                                             "a+b",
                                             "x_",
                                             "x__1",
                                             "x_1_2",
                                             "(x)",
                                             "g(x)",
                                             "x=1",
                                             "\\vec{1, 0, 0}",
                                             "\\",
                                             "\\text{}",
                                             "x%",
                                             "x\n",
                                             "x\\,",
                                             "x &",
                                             "é",
                                             "'x",
                                             "x\\end{equation}",
                                             "x = 1\\end{equation}\\begin{equation}y"};
  for (const std::string& none : no_names) EXPECT_EQ(reason(none), "`" + none + "` is not a name");
  for (const char* command : {"\\exp", "\\vec", "\\frac", "\\left", "\\quad", "\\begin", "\\text"}) {
    EXPECT_EQ(reason(command), "`" + std::string(command) + "` is a command, not a name");
  }
  EXPECT_EQ(reason("exp"), "`exp` is a reserved word");
  EXPECT_EQ(reason("max_1"), "`max_1` is a reserved word");
  EXPECT_EQ(reason("\\vec{\\omega_i}"), "`\\vec{\\omega_i}` is a convention of the language");
  EXPECT_EQ(reason("\\pi"), "`\\pi` is a convention of the language");
  EXPECT_EQ(reason(std::string(2000, 'x')), "the name is too long");
  EXPECT_EQ(renamed(source, "  b "), equation("f = b") + equation("b = 1"));
}

TEST(Rename, RefusedWhereANameWouldChangeItsMeaning) {
  EXPECT_EQ(renamed(equation("f = @a + b") + equation("a = 1") + equation("b = 1"), "b"),
            "refused: `b` is defined already, on line 3");
  EXPECT_EQ(renamed(equation("f = g(1)") + equation("g(x) = @a*x") + equation("a = 1"), "x"),
            "refused: on line 2 the parameter `x` of `g` would hide it");
  EXPECT_EQ(renamed(equation("f = a + zz") + equation("@a = 1"), "zz"),
            "refused: `zz` stands on line 1, and would then mean this");
  EXPECT_EQ(renamed(equation("f = g(1, 2)") + equation("g(@x, y) = x*y"), "y"),
            "refused: `g` has another parameter `y`");
  EXPECT_EQ(renamed(equation("f = g(1)") + equation("g(@x) = a*x") + equation("a = 1"), "a"),
            "refused: `a` is used in `g`, where the parameter would hide it");
  EXPECT_EQ(renamed(equation("f = g(\\vec{n})") + equation("g(@\\omega_i) = \\omega_i*\\cos\\theta_i"), "\\vec{x}"),
            "refused: in `g`, `\\theta_i` follows `\\omega_i` because of its name");
}

TEST(Rename, TheBrdfStaysTheSame) {
  const std::string other = equation("h = \\theta_o");
  EXPECT_EQ(renamed(equation("@f = \\theta_i") + other, "x"),
            "refused: `f` is the BRDF because of its name, `x` would not be");
  EXPECT_EQ(renamed(equation("@f = \\theta_i") + other, "f_r"), equation("f_r = \\theta_i") + other);
  EXPECT_EQ(renamed(equation("f = a*\\theta_i") + equation("@a = 1"), "f_0"),
            equation("f = f_0*\\theta_i") + equation("f_0 = 1"));
  EXPECT_EQ(renamed(equation("@h = f*\\theta_i") + equation("f = \\theta_o"), "f_h"),
            "refused: `f` would no longer be the BRDF");
}

TEST(Rename, AnInstructionThatNamesTheRootIsEdited) {
  const std::string above = "%texbrdf:root=g_{1}  \n";
  EXPECT_EQ(renamed(above + equation("@g_1 = \\theta_i"), "h"), "%texbrdf:root=h  \n" + equation("h = \\theta_i"));
  EXPECT_EQ(renamed("% texbrdf: root = @g\r\n\r\n" + equation("f = g") + equation("g = 1"), "\\rho_d"),
            "% texbrdf: root = \\rho_d\r\n\r\n" + equation("f = \\rho_d") + equation("\\rho_d = 1"));
  EXPECT_EQ(renamed("% texbrdf: root = g@\n\n" + equation("g = 1") + "% texbrdf: root = g", "h"),
            "% texbrdf: root = h\n\n" + equation("h = 1") + "% texbrdf: root = h");
  EXPECT_EQ(renamed(above + equation("@g_1 = 1"), "g_{1}"), above + equation("g_{1} = 1"));
  EXPECT_EQ(renamed("% texbrdf: root = g\n\n" + equation("g = a") + equation("@a = 1"), "b"),
            "% texbrdf: root = g\n\n" + equation("g = b") + equation("b = 1"));
  EXPECT_EQ(renamed("% texbrdf: root = x\n\n" + equation("f(@x) = x"), "y"),
            "% texbrdf: root = x\n\n" + equation("f(y) = y"));
}

TEST(Rename, WhatAnInstructionNamesIsNotDefinedByIt) {
  EXPECT_EQ(renamed("% texbrdf: root = zz\n\n" + equation("@a = 1"), "zz"),
            "refused: `zz` stands on line 1, and would then mean this");
  EXPECT_EQ(renamed("% texbrdf: root = @zz\n\n" + equation("a = 1"), "b"), "refused: no name stands here");
  EXPECT_EQ(renamed("% texbrdf: root = g\n\n" + equation("@g = 1") + equation("f = 1"), "f"),
            "refused: `f` is defined already, on line 4");
}

TEST(Rename, ANameOfAnotherFunctionsParameterIsFree) {
  EXPECT_EQ(renamed(equation("f = @a + g(1)") + equation("g(x) = x") + equation("a = 1"), "x"),
            equation("f = x + g(1)") + equation("g(x) = x") + equation("x = 1"));
}

TEST(Rename, TheSpellingOfAParameterKeepsItsType) {
  const std::string use = equation("f = g(\\vec{n})");
  EXPECT_EQ(renamed(use + equation("g(@x) = x*2 + \\vec{n}"), "\\vec{x}"),
            use + equation("g(\\vec{x}) = \\vec{x}*2 + \\vec{n}"));
  EXPECT_EQ(renamed(equation("f = g(1)") + equation("g(@x) = x*2"), "\\vec{x}"),
            "refused: `x` is no vector, `\\vec{x}` would be one");
  EXPECT_EQ(renamed(use + equation("g(@\\vec{x}) = \\vec{x}*\\vec{x}"), "x"),
            "refused: `\\vec{x}` is a vector because of how it is written, `x` need not be one");
}

TEST(PrepareRename, GivesTheNameAsItIsWritten) {
  EXPECT_EQ(prepared(equation("f = @x_{1}") + equation("x_1 = 2")), "x_{1}");
  EXPECT_EQ(prepared(equation("f = g(1)") + equation("g(x) = 2*x@")), "x");
  EXPECT_EQ(prepared(equation("f = 1 @+ 2")), "nothing");
  EXPECT_EQ(prepared("%  texbrdf: root = x_{ 1}@ \n" + equation("x_1 = 2")), "x_{ 1}");
  EXPECT_EQ(prepared("% texbrdf: @root = x\n" + equation("x = 2")), "nothing");
  EXPECT_EQ(prepared("pro@se " + equation("f = 1")), "nothing");
  EXPECT_EQ(prepared(equation("f = @\\pi")), "refused: `\\pi` is a convention of the language and keeps its name");
}

}  // namespace
}  // namespace texbrdf::features
