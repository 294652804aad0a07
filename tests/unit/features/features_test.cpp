#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "analysis/document.h"
#include "features/definition.h"
#include "features/diagnostics.h"
#include "features/document_symbols.h"
#include "features/hover.h"
#include "features/references.h"
#include "ir/print.h"

namespace texbrdf::features {
namespace {

/// A document with a `@` at each place that a test asks about; the marks are taken out.
struct Marked {
  std::string text;
  std::vector<uint32_t> places;
};

Marked marked(std::string_view source) {
  Marked result;
  for (const char c : source) {
    if (c == '@') {
      result.places.push_back(static_cast<uint32_t>(result.text.size()));
    } else {
      result.text += c;
    }
  }
  return result;
}

std::string equation(std::string_view content) {
  return "\\begin{equation}" + std::string(content) + "\\end{equation}\n";
}

/// What is underlined, as text.
std::string text_at(const Snapshot& snapshot, Span span) {
  return std::string(snapshot.text().slice(span));
}

std::string hover_text(const std::string& source) {
  const Marked document = marked(source);
  Document opened(document.text);
  const auto found = hover(opened.snapshot(), document.places.at(0), Markup::PlainText);
  return found ? text_at(opened.snapshot(), found->span) + " | " + found->text : "nothing";
}

TEST(Hover, ADefinitionSaysItsTypeEquationValueAndLine) {
  EXPECT_EQ(hover_text("prose\n" + equation("f = @a_1") + equation(" a_{1} =\n  1/4 ")),
            "a_1 | a_1: ℝ\n\na_{1} = 1/4\n\nvalue 0.25 · defined on line 3");
  EXPECT_EQ(hover_text(equation("@f = \\vec{n}")), "f | f: ℝ³\n\nf = \\vec{n}\n\ndefined on line 1");
  EXPECT_EQ(hover_text(equation("f = @g(\\vec{n})") + equation("g(\\vec{x}) = 2*\\vec{x}")),
            "g | g: ℝ³ → ℝ³\n\ng(\\vec{x}) = 2*\\vec{x}\n\ndefined on line 2");
}

TEST(Hover, ACallSaysTheTypesThatItIsCalledWith) {
  const std::string g = equation("g(x, y) = x \\cdot y");
  EXPECT_EQ(hover_text(equation("f = @g(\\vec{n}, \\vec{h})") + g),
            "g | g: ℝ³ × ℝ³ → ℝ\n\ng(x, y) = x \\cdot y\n\ndefined on line 2");
  EXPECT_EQ(hover_text(equation("f = g(\\vec{n}, \\vec{h}) + @g(1, 2)") + g),
            "g | g: ℝ × ℝ → ℝ\n\ng(x, y) = x \\cdot y\n\ndefined on line 2");
}

TEST(Hover, CasesAndTheirConditionsHaveTypes) {
  const std::string rows = " (1, 0, 0) & \\theta_h > 1 \\land 2 > 1 \\\\ 0 \\end{cases}";
  EXPECT_EQ(hover_text(equation("f = @\\begin{cases}" + rows)),
            "\\begin{cases}" + rows + " | RGB\n\n\\begin{cases}" + rows);
  EXPECT_EQ(hover_text(equation("f = \\begin{cases} 1 & \\theta_h @> 1 \\\\ 0 \\end{cases}")),
            "\\theta_h > 1 | 𝔹\n\n\\theta_h > 1");
  EXPECT_EQ(hover_text(equation("f = @\\chi^+(\\theta_h)")),
            "\\chi^+ | \\chi^+: ℝ → ℝ\n\n1 where its argument is positive, else 0\n\n"
            "a function that needs no definition");
}

TEST(Hover, AVectorHasThreeValues) {
  EXPECT_EQ(hover_text(equation("f = @c") + equation("c = 2*\\vec{1, 0, -0.25}")),
            "c | c: ℝ³\n\nc = 2*\\vec{1, 0, -0.25}\n\nvalue (2, 0, -0.5) · defined on line 2");
}

TEST(Hover, AConventionSaysItsFormulaAndMeaning) {
  EXPECT_EQ(hover_text(equation("f = @\\theta_h")),
            "\\theta_h | \\theta_h: ℝ = arccos(N·H)\n\nangle between normal and half vector\n\n"
            "a convention of the language");
}

TEST(Hover, AConventionFollowsAParameterOfItsName) {
  EXPECT_EQ(hover_text(equation("f = g(\\vec{n})") + equation("g(\\omega_i) = \\cos@\\theta_i")),
            "\\theta_i | \\theta_i: ℝ = arccos(N·L)\n\npolar angle of the incident direction\n\n"
            "here of the parameter \\omega_i\n\na convention of the language");
}

TEST(Hover, AParameterSaysItsFunction) {
  EXPECT_EQ(hover_text(equation("f = g(1)") + equation("g(x) = 2*@x")), "x | x: ℝ\n\nparameter of g");
  EXPECT_EQ(hover_text(equation("f = 1") + equation("g(x) = \\vec{n} + @x")),
            "x | x: ℝ³\n\nparameter of g, a vector because of how it is used");
}

TEST(Hover, AnOperatorOrABracketSaysTheTypeOfItsExpression) {
  EXPECT_EQ(hover_text(equation("f = 1 + 2 @* 3")), "2 * 3 | ℝ\n\n2 * 3");
  EXPECT_EQ(hover_text(equation("f = 1 @+ 2 * 3")), "1 + 2 * 3 | ℝ\n\n1 + 2 * 3");
  EXPECT_EQ(hover_text(equation("f = 2 * @(\\vec{n}\n % why\n + \\vec{h})")),
            "(\\vec{n}\n % why\n + \\vec{h}) | ℝ³\n\n(\\vec{n} + \\vec{h})");
  EXPECT_EQ(hover_text(equation("f = @\\frac{1}{\\pi}")), "\\frac{1}{\\pi} | ℝ\n\n\\frac{1}{\\pi}");
  EXPECT_EQ(hover_text(equation("f = \\vec{1, 2@, 3}")), "\\vec{1, 2, 3} | ℝ³\n\n\\vec{1, 2, 3}");
  EXPECT_EQ(hover_text(equation("f = g(x@, 1)") + equation("g(a, b) = a") + equation("x = 2")),
            "g(x, 1) | ℝ\n\ng(x, 1)");
}

TEST(Hover, BehindANameTheNextCharacterCounts) {
  EXPECT_EQ(hover_text(equation("f = g@(\\vec{n})") + equation("g(\\vec{x}) = 2*\\vec{x}")),
            "g(\\vec{n}) | ℝ³\n\ng(\\vec{n})");
  EXPECT_EQ(hover_text(equation("f = a@*2") + equation("a = 1")), "a*2 | ℝ\n\na*2");
  EXPECT_EQ(hover_text(equation("f = a@ * 2") + equation("a = 1")), "a | a: ℝ\n\na = 1\n\nvalue 1 · defined on line 2");
}

/// The program of what is hovered as text, or why there is none.
std::string hovered_program(const std::string& source, uint32_t most_values = 1000) {
  const Marked document = marked(source);
  Document opened(document.text);
  const auto found = hover(opened.snapshot(), document.places.at(0), Markup::PlainText);
  if (!found || !found->expression) return "no expression";
  const auto program = program_of(opened.snapshot(), *found->expression, most_values);
  return program ? ir::print_graph(*ir::flatten(*program)) : "no program";
}

TEST(HoveredExpression, IsAProgramOfItsOwn) {
  EXPECT_EQ(hovered_program(equation("f = @a + 1") + equation("a = 2 * m") + equation("m = 3")),
            "%0: ℝ = constant 2\n%1: ℝ = parameter 0\n%2: ℝ = multiply %0 %1\nroots %2\n");
  EXPECT_EQ(hovered_program(equation("f = 1 + 2 @* m") + equation("m = 3")),
            "%0: ℝ = constant 2\n%1: ℝ = parameter 0\n%2: ℝ = multiply %0 %1\nroots %2\n");
  EXPECT_EQ(hovered_program(equation("f(\\vec{l}, \\vec{v}) = 1 + \\vec{l} @\\cdot \\vec{v}")),
            "%0: ℝ³ = convention L\n%1: ℝ³ = convention V\n%2: ℝ = dot %0 %1\nroots %2\n");
  EXPECT_EQ(hovered_program(equation("f = g(1)") + equation("g(x) = x + 2 @* 3")),
            "%0: ℝ = constant 2\n%1: ℝ = constant 3\n%2: ℝ = multiply %0 %1\nroots %2\n");
}

TEST(HoveredExpression, HasNoProgramWithoutArgumentsOrInError) {
  EXPECT_EQ(hovered_program(equation("f = @g(1)") + equation("g(x) = x * 2")), "no program");
  EXPECT_EQ(hovered_program(equation("f = g(1)") + equation("g(x) = x @* 2")), "no program");
  EXPECT_EQ(hovered_program(equation("f = @a") + equation("a = zq * 2")), "no program");
  EXPECT_EQ(hovered_program(equation("f = \\vec{n} @+ a") + equation("a = f")), "no program");
  EXPECT_EQ(hovered_program(equation("f = \\theta@_h")), "no expression");
}

TEST(HoveredExpression, MayNeedSoManyValuesOnly) {
  const std::string chain =
      equation("f = @a_1") + equation("a_1 = a_2 + 1") + equation("a_2 = a_3 + 1") + equation("a_3 = \\theta_h + 1");
  EXPECT_EQ(hovered_program(chain, 8), "no program");
  EXPECT_NE(hovered_program(chain, 20), "no program");
  std::string doubling = equation("f = @a") + equation("a = g_9(\\theta_h)") + equation("g_0(x) = x + x");
  for (int i = 1; i < 10; ++i) {
    doubling += equation(fmt::format("g_{}(x) = g_{}(x) + g_{}(x + 1)", i, i - 1, i - 1));
  }
  EXPECT_EQ(hovered_program(doubling), "no program");
}

TEST(Hover, NothingIsSaidOfWhatIsNoName) {
  for (const char* content : {"f @= 1 + 2", "f = 12@3", "f = nowhere@", "f = (1)@ ", "f = 1 @+", "f = zq @zq"}) {
    EXPECT_EQ(hover_text(equation(content)), "nothing") << content;
  }
  EXPECT_EQ(hover_text("pro@se " + equation("f = 1")), "nothing");
}

TEST(Hover, MarkdownFencesTheEquation) {
  const Marked document = marked(equation("@f = 1"));
  Document opened(document.text);
  EXPECT_EQ(hover(opened.snapshot(), document.places[0], Markup::Markdown)->text,
            "`f`: `ℝ`\n\n```latex\nf = 1\n```\n\nvalue 1 · defined on line 1");
}

TEST(Hover, AHugeEquationIsCutOff) {
  std::string sum = "f@ = 1";
  for (int i = 0; i < 500; ++i) sum += " + 1";
  const std::string text = hover_text(equation(sum));
  EXPECT_LT(text.size(), 1200u);
  EXPECT_NE(text.find(" …\n\nvalue 501"), std::string::npos) << text;
}

TEST(DefinitionLink, LeadsToTheName) {
  const Marked document =
      marked(equation("f = g(@a, 2)") + equation("a = 1") + equation("g(x, y) = @x*y + \\the@ta_i"));
  Document opened(document.text);
  const Snapshot& snapshot = opened.snapshot();
  const auto plain = definition_at(snapshot, document.places[0]);
  ASSERT_TRUE(plain);
  EXPECT_EQ(text_at(snapshot, plain->origin), "a");
  EXPECT_EQ(text_at(snapshot, plain->whole), "a = 1");
  EXPECT_EQ(text_at(snapshot, plain->name), "a");
  const auto parameter = definition_at(snapshot, document.places[1]);
  ASSERT_TRUE(parameter);
  EXPECT_EQ(parameter->name.begin, parameter->whole.begin + 2);
  EXPECT_EQ(text_at(snapshot, parameter->whole), "g(x, y) = x*y + \\theta_i");
  EXPECT_FALSE(definition_at(snapshot, document.places[2]));
}

TEST(References, EveryPlaceOfTheSameThing) {
  const Marked document = marked(equation("f = @a + g(a)") + equation("g(a) = a*@a") + equation("a = 1"));
  Document opened(document.text);
  const Snapshot& snapshot = opened.snapshot();
  EXPECT_EQ(references(snapshot, document.places[0], true).size(), 3u);
  EXPECT_EQ(references(snapshot, document.places[0], false).size(), 2u);
  EXPECT_EQ(references(snapshot, document.places[1], true).size(), 3u);
  EXPECT_EQ(references(snapshot, document.places[1], false).size(), 2u);
  EXPECT_TRUE(references(snapshot, 0, true).empty());
}

TEST(DocumentSymbols, DefinitionsWithTheirParameters) {
  Document opened(equation("f = g(\\vec{n})") + equation("broken = (") + equation("g(\\vec{x}) = 2*\\vec{x}"));
  const Snapshot& snapshot = opened.snapshot();
  const auto symbols = document_symbols(snapshot);
  ASSERT_EQ(symbols.size(), 3u);
  EXPECT_EQ(symbols[0].name, "f");
  EXPECT_EQ(symbols[0].type, "ℝ³");
  EXPECT_EQ(symbols[0].kind, SymbolKind::Variable);
  EXPECT_EQ(symbols[2].kind, SymbolKind::Function);
  EXPECT_EQ(symbols[2].type, "ℝ³ → ℝ³");
  ASSERT_EQ(symbols[2].children.size(), 1u);
  EXPECT_EQ(symbols[2].children[0].name, "\\vec{x}");
  for (const Symbol& symbol : symbols) {
    EXPECT_LE(symbol.whole.begin, symbol.selection.begin);
    EXPECT_GE(symbol.whole.end, symbol.selection.end);
  }
}

TEST(Diagnostics, AreFormedWithAbsoluteRanges) {
  Document opened("θ " + equation("a = 1") + equation("f = a + zz") + equation("a = 2"));
  const Snapshot& snapshot = opened.snapshot();
  const auto shown = diagnostics(snapshot, nullptr);
  ASSERT_EQ(shown.size(), 2u);
  EXPECT_EQ(text_at(snapshot, shown[0].span), "zz");
  EXPECT_EQ(shown[0].severity, Severity::Error);
  EXPECT_NE(shown[0].message.find("`zz`"), std::string::npos);
  EXPECT_EQ(text_at(snapshot, shown[1].span), "a");
  ASSERT_EQ(shown[1].related.size(), 1u);
  EXPECT_EQ(shown[1].related[0].span.begin, std::string("θ \\begin{equation}").size());
}

/// Seen from whatever file, each has the diagnostics that are seen from itself.
TEST(Diagnostics, OfAllFilesAreThoseOfEach) {
  const std::string unclosed = "% texbrdf: nonsense\n\\begin{equation}c = (1\\end{equation}";
  Document document(equation("f = a + zz") + "% texbrdf: more\n");
  document.insert_file({1}, SourceText(equation("a = b") + equation("a = 1") + unclosed));
  document.insert_file({2}, SourceText(""));
  document.insert_file({3}, SourceText(equation("b = yy") + equation("a = 2") + equation("unused = 1")));
  for (uint32_t seen_from = 0; seen_from < document.file_count(); ++seen_from) {
    const Snapshot& snapshot = document.snapshot({seen_from});
    const std::vector<std::vector<ShownDiagnostic>> files = diagnostics_by_file(snapshot, nullptr);
    ASSERT_EQ(files.size(), document.file_count());
    for (uint32_t file = 0; file < files.size(); ++file) {
      const std::vector<ShownDiagnostic> own = diagnostics(document.snapshot({file}), nullptr);
      ASSERT_EQ(files[file].size(), own.size()) << file;
      for (std::size_t i = 0; i < own.size(); ++i) {
        EXPECT_EQ(files[file][i].message, own[i].message);
        EXPECT_EQ(snapshot.place(files[file][i].span).file, FileId{file});
        EXPECT_EQ(snapshot.place(files[file][i].span).span, own[i].span);
      }
    }
  }
}

}  // namespace
}  // namespace texbrdf::features
