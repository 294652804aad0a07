#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "analysis/document.h"
#include "features/code_lenses.h"
#include "features/document_highlights.h"
#include "features/folding_ranges.h"
#include "features/inlay_hints.h"

namespace texbrdf::features {
namespace {

std::string equation(std::string_view content) {
  return "\\begin{equation}" + std::string(content) + "\\end{equation}\n";
}

uint32_t place_of(const std::string& document, std::string_view text) {
  return static_cast<uint32_t>(document.find(text));
}

// --- document highlight ---

/// The document with the highlighted names in brackets, written ones in [[ ]].
std::string highlighted(const std::string& document, std::string_view at) {
  Document opened(document);
  std::string text;
  uint32_t done = 0;
  for (const Highlight& highlight : document_highlights(opened.snapshot(), place_of(document, at))) {
    text += document.substr(done, highlight.span.begin - done);
    const std::string name = document.substr(highlight.span.begin, highlight.span.size());
    text += highlight.writes ? "[[" + name + "]]" : "[" + name + "]";
    done = highlight.span.end;
  }
  return text + document.substr(done);
}

TEST(DocumentHighlights, ReadAndWrittenPlacesOfOneThing) {
  const std::string document = equation("f = x_1 + g(2)") + equation("g(x_1) = x_{1}") + equation("x_{1} = 3");
  EXPECT_EQ(highlighted(document, "x_1 + g"),
            equation("f = [x_1] + g(2)") + equation("g(x_1) = x_{1}") + equation("[[x_{1}]] = 3"));
  EXPECT_EQ(highlighted(document, "x_1) ="),
            equation("f = x_1 + g(2)") + equation("g([[x_1]]) = [x_{1}]") + equation("x_{1} = 3"));
  EXPECT_EQ(highlighted(document, "+ g"), document);
}

TEST(DocumentHighlights, ConventionsAndUndefinedNamesToo) {
  const std::string document = equation("f = \\pi + zz") + equation("a = zz*\\pi");
  EXPECT_EQ(highlighted(document, "\\pi"), equation("f = [\\pi] + zz") + equation("a = zz*[\\pi]"));
  EXPECT_EQ(highlighted(document, "zz"), equation("f = \\pi + [zz]") + equation("a = [zz]*\\pi"));
}

// --- folding ---

/// What folds away.
std::vector<std::string> folded(const std::string& document) {
  Document opened(document);
  std::vector<std::string> texts;
  for (const Fold& fold : folding_ranges(opened.snapshot())) {
    texts.push_back(document.substr(fold.inside.begin, fold.inside.size()) + (fold.has_end ? "" : "!"));
  }
  return texts;
}

TEST(FoldingRanges, BlocksOverSeveralLines) {
  EXPECT_EQ(folded("prose\n\n" + equation("\n a = 1\n") + equation("b = 2") + equation(" c =\r 3")),
            (std::vector<std::string>{"\n a = 1\n", " c =\r 3"}));
}

TEST(FoldingRanges, AnUnclosedBlockEndsWithItsText) {
  EXPECT_EQ(folded("\\begin{equation}\n a =\n 1 \n\nprose"), (std::vector<std::string>{"\n a =\n 1!"}));
  EXPECT_EQ(folded("\\begin{equation} a = 1\n\nprose"), (std::vector<std::string>{}));
  EXPECT_EQ(folded("\\begin{equation}\n"), (std::vector<std::string>{}));
}

// --- inlay hints ---

/// The document with the hints where they are shown, in braces.
std::string hinted(const std::string& document, const InlayHintOptions& options = {}, Span range = {0, UINT32_MAX}) {
  Document opened(document);
  std::string text;
  uint32_t done = 0;
  for (const InlayHint& hint : inlay_hints(opened.snapshot(), range, options)) {
    text += document.substr(done, hint.offset - done) + "⟨" + hint.label + "⟩";
    done = hint.offset;
  }
  return text + document.substr(done);
}

TEST(InlayHints, TypesAndValues) {
  EXPECT_EQ(hinted(equation("a = 1/4") + equation("b = a*\\vec{1, 0, 2}")),
            equation("a⟨: ℝ⟩ = 1/4⟨= 0.25⟩") + equation("b⟨: ℝ³⟩ = a*\\vec{1, 0, 2}⟨= (0.25, 0, 0.5)⟩"));
  EXPECT_EQ(hinted(equation("f = g(\\vec{n}, 2, \\vec{h})") + equation("g(u, x, \\vec{v}) = (u + \\vec{v})*x")),
            equation("f⟨: ℝ³⟩ = g(\\vec{n}, 2, \\vec{h})") +
                equation("g(u⟨: ℝ³⟩, x⟨: ℝ⟩, \\vec{v})⟨: ℝ³⟩ = (u + \\vec{v})*x"));
}

TEST(InlayHints, ALiteralSaysItsValueItself) {
  EXPECT_EQ(hinted(equation("a = -0.5") + equation("\\vec{c} = \\vec{1, 0, 0}")),
            equation("a⟨: ℝ⟩ = -0.5") + equation("\\vec{c}⟨: ℝ³⟩ = \\vec{1, 0, 0}"));
}

TEST(InlayHints, NothingIsSaidOfWhatIsInError) {
  EXPECT_EQ(hinted(equation("a = 1 + \\vec{n}") + equation("b = (1")),
            equation("a = 1 + \\vec{n}") + equation("b = (1"));
}

TEST(InlayHints, EachKindCanBeSwitchedOff) {
  const std::string document = equation("g(x) = 2*x") + equation("a = 1 + 1");
  const auto with = [&](bool definitions, bool parameters, bool values) {
    return hinted(document, {definitions, parameters, values});
  };
  EXPECT_EQ(with(true, false, false), equation("g(x)⟨: ℝ⟩ = 2*x") + equation("a⟨: ℝ⟩ = 1 + 1"));
  EXPECT_EQ(with(false, true, false), equation("g(x⟨: ℝ⟩) = 2*x") + equation("a = 1 + 1"));
  EXPECT_EQ(with(false, false, true), equation("g(x) = 2*x") + equation("a = 1 + 1⟨= 2⟩"));
}

TEST(InlayHints, OnlyInTheRange) {
  const std::string document = equation("a = 1") + equation("b = 2") + equation("c = 3");
  const uint32_t b = place_of(document, "b =");
  EXPECT_EQ(hinted(document, {}, {b, b + 3}), equation("a = 1") + equation("b⟨: ℝ⟩ = 2") + equation("c = 3"));
  EXPECT_EQ(hinted(document, {}, {b, b}), document);
}

// --- code lenses ---

std::string lenses_of(const std::string& document, const CodeLensOptions& options) {
  Document opened(document);
  std::string text;
  for (const CodeLens& lens : code_lenses(opened.snapshot(), options)) {
    text += lens.kind == CodeLens::Kind::Preview ? "preview " : "";
    text += std::string(lens.name) + "@" + std::to_string(lens.span.begin) + " ";
  }
  return text;
}

TEST(CodeLenses, UsesOfDefinitionsAndThePreviewOfTheRoot) {
  const std::string document = equation("a = 1") + equation("f = a") + equation("a = 2") + equation("x_1 = a");
  const std::string a = "a@" + std::to_string(place_of(document, "a = 1"));
  const std::string f = "preview f@" + std::to_string(place_of(document, "f ="));
  const std::string x = "x_1@" + std::to_string(place_of(document, "x_1"));
  EXPECT_EQ(lenses_of(document, {.preview = true, .uses = true}), a + " " + f + " " + x + " ");
  EXPECT_EQ(lenses_of(document, {.preview = false, .uses = true}), a + " " + x + " ");
  EXPECT_EQ(lenses_of(document, {.preview = true, .uses = false}), f + " ");
}

TEST(CodeLenses, UsesAreCounted) {
  Document opened(equation("f = a + a*g(1)") + equation("g(a) = a") + equation("a = 2") + equation("a = a_1"));
  EXPECT_EQ(count_uses(opened.snapshot(), "a"), 2u);
  EXPECT_EQ(count_uses(opened.snapshot(), "g"), 1u);
  EXPECT_EQ(count_uses(opened.snapshot(), "f"), 0u);
  EXPECT_EQ(count_uses(opened.snapshot(), "nowhere"), 0u);
}

}  // namespace
}  // namespace texbrdf::features
