#include "diagnostics/render_terminal.h"

#include <gtest/gtest.h>

namespace texbrdf {
namespace {

std::string render(const std::string& document, Diagnostic diagnostic, bool colour = false) {
  const SourceText text(document);
  const PlaceFinder find_place = [&text](const Location& where) { return Place{"paper.tex", &text, where.span}; };
  return render_terminal(diagnostic, find_place, {.colour = colour});
}

Diagnostic unknown_character(Span span, std::string text = ";") {
  return make_diagnostic(Code::UnknownCharacter, {{}, {}, span}, {std::move(text)});
}

TEST(RenderTerminal, writes_the_place_the_line_before_the_line_and_carets) {
  EXPECT_EQ(render("one\n  a = ω;;\n", unknown_character({12, 14})),
            "paper.tex(2:8) error: unexpected character `;` [E1001]\n"
            "one\n"
            "  a = ω;;\n"
            "       ^^\n");
}

TEST(RenderTerminal, writes_no_line_before_the_first) {
  EXPECT_EQ(render("a;", unknown_character({1, 2})),
            "paper.tex(1:2) error: unexpected character `;` [E1001]\na;\n ^\n");
}

TEST(RenderTerminal, marks_the_end_of_the_document_with_one_caret) {
  EXPECT_EQ(render("a", unknown_character({1, 1})), "paper.tex(1:2) error: unexpected character `;` [E1001]\na\n ^\n");
}

TEST(RenderTerminal, marks_only_the_first_line_of_a_range) {
  EXPECT_EQ(render("ab\ncd", unknown_character({1, 5})),
            "paper.tex(1:2) error: unexpected character `;` [E1001]\nab\n ^\n");
}

TEST(RenderTerminal, writes_related_places_and_fixes_below) {
  Diagnostic diagnostic = unknown_character({1, 2});
  diagnostic.related.push_back({{{}, {}, {3, 4}}, "it starts here"});
  diagnostic.fixes.push_back({"remove `;`", {}});
  EXPECT_EQ(render("a;\nb", diagnostic),
            "paper.tex(1:2) error: unexpected character `;` [E1001]\na;\n ^\n"
            "paper.tex(2:1) note: it starts here\na;\nb\n^\n"
            "fix: remove `;`\n");
}

TEST(RenderTerminal, shows_no_control_characters_and_keeps_carets_below_tabs) {
  EXPECT_EQ(render("\t\x1b[2J;", unknown_character({5, 6})),
            "paper.tex(1:6) error: unexpected character `;` [E1001]\n    \uFFFD[2J;\n        ^\n");
}

TEST(RenderTerminal, cuts_long_lines_around_the_range) {
  const std::string shown =
      render(std::string(100'000, 'x') + ";" + std::string(100'000, 'y'), unknown_character({100'000, 100'001}));
  EXPECT_LT(shown.size(), 600u);
  const size_t line = shown.find('\n') + 1;
  const size_t carets = shown.find('\n', line) + 1;
  // The ellipsis in front takes three bytes and one column.
  EXPECT_EQ(shown.find('^') - carets, shown.find(';', line) - line - 2);
}

TEST(RenderTerminal, colours_only_when_asked) {
  EXPECT_EQ(render("a;", unknown_character({1, 2})).find('\x1b'), std::string::npos);
  EXPECT_NE(render("a;", unknown_character({1, 2}), true).find("\x1b[1;31merror\x1b[0m"), std::string::npos);
}

}  // namespace
}  // namespace texbrdf
