#include "syntax/block_scanner.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>

namespace texbrdf {
namespace {

std::string_view end_name(BlockEnd end) {
  switch (end) {
    case BlockEnd::Closed:
      return "closed";
    case BlockEnd::WrongEnd:
      return "wrong-end";
    case BlockEnd::NextBegin:
      return "next-begin";
    case BlockEnd::BlankLine:
      return "blank-line";
    case BlockEnd::DocumentEnd:
      return "document-end";
  }
  return {};
}

/// `content:end` of each block.
std::string blocks_text(std::string_view document, TextLanguage language = TextLanguage::Latex) {
  std::string text;
  for (const BlockExtent& block : scan_blocks(document, language)) {
    const std::string_view whole = document.substr(block.whole.begin, block.whole.size());
    const bool is_environment = block.region == MathRegion::Environment;
    EXPECT_TRUE(whole.starts_with(is_environment ? "\\begin" : opener_of(block.region))) << whole;
    EXPECT_EQ(block.begin.end, block.content.begin);
    EXPECT_EQ(block.content.end, block.end.begin);
    if (!block.end.empty() && block.ended_by == BlockEnd::Closed) {
      const std::string_view end = whole.substr(block.end.begin, block.end.size());
      const bool is_shortcut = block.region == MathRegion::Shortcut;
      EXPECT_EQ(is_shortcut ? end.substr(0, 2) : end,
                is_shortcut ? "\\e" : (is_environment ? "\\end" : closer_of(block.region)));
    }
    text += "[";
    text += whole.substr(block.content.begin, block.content.size());
    text += ":";
    text += end_name(block.ended_by);
    text += "]";
  }
  return text;
}

struct Case {
  const char* name;
  const char* document;
  const char* blocks;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.document;
}

class BlockScanner : public testing::TestWithParam<Case> {};

TEST_P(BlockScanner, finds_the_blocks) {
  EXPECT_EQ(blocks_text(GetParam().document), GetParam().blocks);
}

constexpr Case kCases[] = {
    {"none", "prose costs $5", ""},
    {"empty_document", "", ""},
    {"one", "a\\begin{equation}b\\end{equation}c", "[b:closed]"},
    {"starred", "\\begin{equation*}b\\end{equation*}", "[b:closed]"},
    {"empty_block", "\\begin{equation}\\end{equation}", "[:closed]"},
    {"two", "\\begin{equation}a\\end{equation}\\begin{equation}b\\end{equation}", "[a:closed][b:closed]"},
    {"before_document", "\\begin{equation}a\\end{equation}\\begin{document}\\begin{equation}b\\end{equation}",
     "[a:closed][b:closed]"},
    {"behind_document", "\\begin{equation}a\\end{equation}\\end{document}\\begin{equation}b\\end{equation}",
     "[a:closed]"},
    {"document_end_in_comment", "% \\end{document}\n\\begin{equation}a\\end{equation}", "[a:closed]"},
    {"other_environments", "\\begin{table}x\\end{table}\\begin{equation}a\\end{equation}", "[a:closed]"},
    {"displays", "\\begin{align*}x\\end{align*}\\begin{eqnarray}a\\end{eqnarray}", "[x:closed][a:closed]"},
    {"inner_environment_alone", "\\begin{split}x\\end{split}", ""},
    {"double_dollars", "a $$b$$ c", "[b:closed]"},
    {"double_dollars_without_end", "$$a=1\n\n$$b$$", "[a=1\n:blank-line][b:closed]"},
    {"double_dollars_closed_by_one", "$$a$ b", "[a:wrong-end]"},
    {"double_dollars_around_an_environment", "$$\\begin{align}a\\end{align}$$", "[\\begin{align}a\\end{align}:closed]"},
    {"dollar_in_text", "$$a\\text{ if $b=c$}$$", "[a\\text{ if $b=c$}:closed]"},
    {"brackets", "\\[a\\] \\[b\\]", "[a:closed][b:closed]"},
    {"brackets_without_end", "\\[a \\[b\\]", "[a :next-begin][b:closed]"},
    {"line_distance_is_no_bracket", "a\\\\[2pt] b", ""},
    {"inline_prose", "$a$, $b \\in [0,1]$, \\(c\\) and $x_{i=1}$", ""},
    {"inline", "$a = 1$, \\(b = 2\\) and $c\\approx 3$", "[a = 1:closed][b = 2:closed][c\\approx 3:closed]"},
    {"inline_side_by_side", "$a=1$$b=2$", "[a=1:closed][b=2:closed]"},
    {"inline_without_end", "costs $5 = a\n\n$b=1$", "[b=1:closed]"},
    {"inline_before_a_block", "costs $5 = \\begin{equation}a\\end{equation}$b=1$", "[a:closed][b=1:closed]"},
    {"inline_before_an_item", "costs $5 =\n\\item $b=1$", "[b=1:closed]"},
    {"stray_dollar", "costs 5$ and $b=1$, or 6$ and $c=2$", "[b=1:closed][c=2:closed]"},
    {"words_in_dollars", "$ val $ and $b=1$", "[b=1:closed]"},
    {"stray_dollar_before_a_display", "costs 5$ or $$b=1$$", "[b=1:closed]"},
    {"escaped_dollar", "\\$5 = \\$6 $b=1$", "[b=1:closed]"},
    {"dollar_in_comment", "% $a\n$b=1$", "[b=1:closed]"},
    {"dollar_in_comment_of_a_formula", "$b= % $\n1$", "[b= % $\n1:closed]"},
    {"equals_in_braces", "$\\sum_{i=0}^n i$", ""},
    {"formula_in_an_environment", "\\begin{equation}a\\text{ if $b=c$}\\end{equation}", "[a\\text{ if $b=c$}:closed]"},
    {"space_before_brace", "\\begin {equation}a\\end\t{equation}", "[a:closed]"},
    {"longer_command", "\\beginning{equation}a\\end{equation}", ""},
    {"line_break_before_begin", "\\\\begin{equation}a\\end{equation}", ""},
    {"comment", "% \\begin{equation}a\\end{equation}\n", ""},
    {"comment_ends_at_carriage_return", "% no\r\\begin{equation}a\\end{equation}", "[a:closed]"},
    {"comment_at_the_end", "\\begin{equation}a\\end{equation}%", "[a:closed]"},
    {"escaped_percent", "5\\% \\begin{equation}a\\end{equation}", "[a:closed]"},
    {"percent_behind_line_break", "\\\\% \\begin{equation}a\\end{equation}", ""},
    {"comment_inside", "\\begin{equation}a % \\end{equation}\n+b\\end{equation}", "[a % \\end{equation}\n+b:closed]"},
    {"verbatim", "\\begin{verbatim}\\begin{equation}a\\end{equation}\\end{verbatim}\\begin{equation}b\\end{equation}",
     "[b:closed]"},
    {"percent_in_verbatim", "\\begin{verbatim}%\\end{verbatim}\\begin{equation}b\\end{equation}", "[b:closed]"},
    {"listing", "\\begin{lstlisting}[language=C]\\begin{equation}a\\end{equation}\\end{lstlisting}", ""},
    {"comment_environment", "\\begin{comment}\\begin{equation}a\\end{equation}\\end{comment}", ""},
    {"verbatim_without_end", "\\begin{verbatim}\\begin{equation}a\\end{equation}", ""},
    {"verb", "\\verb|\\begin{equation}|\\begin{equation}a\\end{equation}", "[a:closed]"},
    {"verb_star", "\\verb*+%\\begin{equation}+ \\begin{equation}a\\end{equation}", "[a:closed]"},
    {"verb_without_end", "\\verb|abc\n\\begin{equation}a\\end{equation}", "[a:closed]"},
    {"verb_at_the_end", "\\verb", ""},
    {"backslash_at_the_end", "a\\", ""},
    {"next_begin", "\\begin{equation}a \\begin{equation}b\\end{equation}", "[a :next-begin][b:closed]"},
    {"blank_line", "\\begin{equation}\na\n \t\nprose\n\\begin{equation}b\\end{equation}",
     "[\na\n:blank-line][b:closed]"},
    {"blank_line_crlf", "\\begin{equation}\r\na\r\n\r\nprose", "[\r\na\r\n:blank-line]"},
    {"crlf_is_no_blank_line", "\\begin{equation}\r\na\r\nb", "[\r\na\r\nb:document-end]"},
    {"blank_line_lone_cr", "\\begin{equation}a\r\rprose", "[a\r:blank-line]"},
    {"comment_line_is_not_blank", "\\begin{equation}a\n%\nb", "[a\n%\nb:document-end]"},
    {"blank_line_in_a_closed_block", "\\begin{equation}a\n\nb\\end{equation}", "[a\n\nb:closed]"},
    {"document_end", "\\begin{equation}a\\end{document}", "[a:document-end]"},
    {"end_of_file", "\\begin{equation}a", "[a:document-end]"},
    {"wrong_end", "\\begin{equation}a\\end{equation*}b", "[a:wrong-end]"},
    {"wrong_end_behind_blank_line", "\\begin{equation}a\n\nb\\end{theorem}", "[a\n:blank-line]"},
    {"inner_environment", "\\begin{equation}a\\begin{cases}b\\end{cases}\\end{equation}",
     "[a\\begin{cases}b\\end{cases}:closed]"},
    {"inner_environment_without_end", "\\begin{equation}a\\begin{cases}b\\end{equation}", "[a\\begin{cases}b:closed]"},
    {"end_in_verb_inside", "\\begin{equation}a\\verb|\\end{equation}|\\end{equation}",
     "[a\\verb|\\end{equation}|:closed]"},
    {"shortcut", "a \\be b=1\\ee c", "[ b=1:closed]"},
    {"shortcut_of_rows", "\\bea a&=&1\\\\b&=&2\\eea", "[ a&=&1\\\\b&=&2:closed]"},
    {"shortcut_and_its_definition", "\\newcommand{\\be}{\\begin{equation}}\\def\\ee{\\end{equation}}\n\\be a\\ee",
     "[ a:closed]"},
    {"shortcut_without_end", "\\be a=1\n\n\\ee $b=1$", "[b=1:closed]"},
    {"shortcut_before_another", "\\be a=1 \\be b=1\\ee", "[ b=1:closed]"},
    {"shortcut_with_another_end", "\\be a=1 \\eea $b=1$", "[b=1:closed]"},
    {"end_of_a_shortcut_in_an_environment", "\\begin{equation}\\ee^x\\end{equation}", "[\\ee^x:closed]"},
    {"brace_without_end", "\\begin{equation \\begin{equation}a\\end{equation}", "[a:closed]"},
};

INSTANTIATE_TEST_SUITE_P(Documents, BlockScanner, testing::ValuesIn(kCases),
                         [](const auto& param_info) { return std::string(param_info.param.name); });

class MarkdownBlocks : public testing::TestWithParam<Case> {};

TEST_P(MarkdownBlocks, are_found) {
  EXPECT_EQ(blocks_text(GetParam().document, TextLanguage::Markdown), GetParam().blocks);
}

constexpr Case kMarkdownCases[] = {
    {"display", "# Title\n\n$$\nf = 1\n$$\n", "[\nf = 1\n:closed]"},
    {"all_kinds", "\\[a=1\\] \\(b=2\\) $c=3$ \\begin{align}d=4\\end{align}",
     "[a=1:closed][b=2:closed][c=3:closed][d=4:closed]"},
    {"percent_is_text", "100% $a=1$", "[a=1:closed]"},
    {"percent_in_mathematics", "$$a=1 % $$\n$$", "[a=1 % $$\n:closed]"},
    {"prices", "costs $5 and $6, or 5\\$ and $a=1$", "[a=1:closed]"},
    {"inline_code", "`$a=1$` and ``$b=1` $c=1$`` $d=1$", "[d=1:closed]"},
    {"inline_code_of_two_lines", "`$a=1$\n$b=1$` $c=1$", "[c=1:closed]"},
    {"no_code_over_a_blank_line", "` $a=1$\n\n` $b=1$", "[a=1:closed][b=1:closed]"},
    {"lone_backtick", "a ` $a=1$ and ``", "[a=1:closed]"},
    {"escaped_backtick", "\\` $a=1$ `", "[a=1:closed]"},
    {"code_between_dollars", "costs 5$, see `$x=` and $a=1$", "[a=1:closed]"},
    {"fence", "```tex\n$a=1$\n\n$$b=1$$\n```\n$c=1$", "[c=1:closed]"},
    {"tildes", "~~~ `tex`\n$a=1$\n```\n~~~\n$c=1$", "[c=1:closed]"},
    {"indented_fence", "   ```\n$a=1$\n  ```  \n$c=1$", "[c=1:closed]"},
    {"four_spaces_close_no_fence", "```\n$a=1$\n    ```\n$b=1$\n```\n$c=1$", "[c=1:closed]"},
    {"longer_fence", "````\n$a=1$\n```\n$b=1$\n`````\n$c=1$", "[c=1:closed]"},
    {"closing_fence_has_no_word", "```\n$a=1$\n```tex\n$b=1$\n```\n$c=1$", "[c=1:closed]"},
    {"open_fence", "$a=1$\n```\n$b=1$\n\n$c=1$", "[a=1:closed]"},
    {"fence_ends_inline_code", "`a\n```\n$b=1$`\n```\n$c=1$", "[c=1:closed]"},
    {"fence_in_crlf", "```\r\n$a=1$\r\n```\r\n$c=1$", "[c=1:closed]"},
    {"no_fence_behind_mathematics", "$$a=1$$```\n$b=1$", "[a=1:closed][b=1:closed]"},
    {"fence_of_mathematics", "```math\na=1\n\nb=1\n```\n$c=1$", "[a=1\n\nb=1\n:closed][c=1:closed]"},
    {"tildes_of_mathematics", "~~~~ math \na=1\n~~~\n~~~~\n$c=1$", "[c=1:closed]"},
    {"open_fence_of_mathematics", "```math\na=1", "[a=1:document-end]"},
    {"fence_of_mathematics_and_words", "```math2\na=1\n```\n``` math b\nc=1\n```", ""},
    {"backtick_dollars", "$`a=1`$ and $`b`$, `$`c=1$ or $`d=1$", "[a=1:closed]"},
    {"html_comment", "<!-- $a=1$\n\n$b=1$ --> $c=1$", "[c=1:closed]"},
    {"open_html_comment", "$a=1$ <!-- $b=1$", "[a=1:closed]"},
    {"less_than", "a < b <! $a=1$", "[a=1:closed]"},
};

INSTANTIATE_TEST_SUITE_P(Documents, MarkdownBlocks, testing::ValuesIn(kMarkdownCases),
                         [](const auto& param_info) { return std::string(param_info.param.name); });

TEST(BlockScannerDirectives, of_markdown_belong_to_the_block_below_them) {
  for (const char* document : {"<!-- texbrdf: root = g -->\n$$ g = 1 $$ prose", "<!--texbrdf: ignore-->$$x=y$$",
                               "<!-- texbrdf: allow E3013 -->\n<!-- why -->\n\\[g=1\\] prose"}) {
    size_t directives = 0;
    for (const DocumentPart& part : scan_parts(document, TextLanguage::Markdown)) directives += part.directives.size();
    EXPECT_EQ(directives, 0u) << document;
    EXPECT_EQ(scan_blocks(document, TextLanguage::Markdown).size(), 1u) << document;
  }
}

TEST(BlockScannerDirectives, belong_to_the_block_below_them) {
  for (const char* document : {"% texbrdf: root = g\n\\[ g = 1 \\] and prose", "% texbrdf: ignore\n$x=y$\nand prose",
                               "\\[h=1\\]% texbrdf: allow E3013\n\\[g=1\\] prose"}) {
    size_t directives = 0;
    for (const DocumentPart& part : scan_parts(document)) directives += part.directives.size();
    EXPECT_EQ(directives, 0u) << document;
  }
}

TEST(BlockScannerSpeed, is_linear_in_documents_made_to_be_slow) {
  constexpr std::string_view kPieces[] = {"\\begin{equation}",
                                          "\\begin{equation}a\n\n",
                                          "\\begin{",
                                          "\\verb|a|",
                                          "\\",
                                          "%",
                                          "\\begin{verbatim}",
                                          "\\end{x}",
                                          "\\begin{x}",
                                          "$",
                                          "$$",
                                          "$a=",
                                          "\\[",
                                          "\\(a=",
                                          "$\\begin{x}",
                                          "\n",
                                          "`",
                                          "` ``",
                                          "\n```",
                                          "\n```a`",
                                          "~ ",
                                          "<!--",
                                          "<!-- texbrdf: ignore -->",
                                          "$`\\text{",
                                          "$`a",
                                          "\\be ",
                                          "\n```math\n"};
  for (const std::string_view piece : kPieces) {
    std::string document;
    while (document.size() < 4'000'000) document += piece;
    for (const TextLanguage language : {TextLanguage::Latex, TextLanguage::Markdown}) {
      const auto start = std::chrono::steady_clock::now();
      scan_blocks(document, language);
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
      EXPECT_LT(passed.count(), 5.0) << piece;
    }
  }
}

}  // namespace
}  // namespace texbrdf
