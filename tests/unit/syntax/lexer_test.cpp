#include "syntax/lexer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "support/random.h"
#include "syntax/control_words.h"

namespace texbrdf {
namespace {

/// `Kind|text` of each token but the last.
std::string tokens_text(std::string_view text) {
  const auto size = static_cast<uint32_t>(text.size());
  const LexedContent content = lex(text, {0, size}, false, {size, size});
  EXPECT_EQ(content.tokens.back().kind, TokenKind::End);
  std::string shown;
  for (size_t i = 0; i + 1 < content.tokens.size(); ++i) {
    const Token& token = content.tokens[i];
    if (i > 0) shown += ' ';
    shown += token_kind_name(token.kind);
    shown += '|';
    shown += text.substr(token.span.begin, token.span.size());
  }
  return shown;
}

struct Case {
  const char* text;
  const char* tokens;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.text;
}

class Lexer : public testing::TestWithParam<Case> {};

TEST_P(Lexer, splits_into_tokens) {
  EXPECT_EQ(tokens_text(GetParam().text), GetParam().tokens);
}

constexpr Case kNumbers[] = {
    {"12", "Number|12"},          {"0.13", "Number|0.13"},
    {".5", "Number|.5"},          {"1e-3", "Number|1e-3"},
    {"1E+30", "Number|1E+30"},    {".5e2", "Number|.5e2"},
    {"2e", "Number|2 Word|e"},    {"2e-x", "Number|2 Word|e Minus|- Word|x"},
    {"1.", "Number|1 Unknown|."}, {"1.2.3", "Number|1.2 Number|.3"},
    {"2x", "Number|2 Word|x"},
};
INSTANTIATE_TEST_SUITE_P(Numbers, Lexer, testing::ValuesIn(kNumbers));

constexpr Case kNames[] = {
    {"uH", "Word|uH"},
    {"Beckmann", "Word|Beckmann"},
    {"\\rho_d", "Macro|\\rho Underscore|_ Word|d"},
    {"\\text{cook\\_torrance}", "Text|\\text{cook\\_torrance}"},
    {"\\text {a {b} c}x", "Text|\\text {a {b} c} Word|x"},
    {"\\mathrm{a}", "Text|\\mathrm{a}"},
    {"\\text{a\\}}", "Text|\\text{a\\}}"},
    {"\\text{a % }\n}", "Text|\\text{a % }\n}"},
    {"\\text", "Unknown|\\text"},
    {"\\text{a", "Unknown|\\text OpenBrace|{ Word|a"},
    {"\\text{a\\verb|}|}", "Unknown|\\text OpenBrace|{ Word|a Unknown|\\verb|}| CloseBrace|}"},
    {"\\label{\\begin{x}}a", "OpenBrace|{ Unknown|\\begin OpenBrace|{ Word|x CloseBrace|} CloseBrace|} Word|a"},
    {"\\textgreek{a}", "Macro|\\textgreek OpenBrace|{ Word|a CloseBrace|}"},
    {"\\textbf{ab}", "Vec|\\textbf OpenBrace|{ Word|ab CloseBrace|}"},
    {"\\mathbf nl", "Vec|\\mathbf Word|n Word|l"},
    {"\\vec\\omega", "Vec|\\vec Macro|\\omega"},
    {"{\\bf nl}", "OpenBrace|{ Vec|\\bf Word|nl CloseBrace|}"},
    {"{\\rm spec }x", "Text|{\\rm spec } Word|x"},
    {"{\\rm }\\rm", "OpenBrace|{ CloseBrace|}"},
    {"{\\rm a{b}}", "OpenBrace|{ Word|a OpenBrace|{ Word|b CloseBrace|} CloseBrace|}"},
    {"\\mathrm dx", "Text|\\mathrm d Word|x"},
    {"\\operatorname*{lerp}", "Text|\\operatorname*{lerp}"},
    {"\\bar\\mu'", "Accent|\\bar Macro|\\mu Prime|'"},
    {"x^{\\prime}", "Word|x Caret|^ OpenBrace|{ Prime|\\prime CloseBrace|}"},
    {"\\vec{n}", "Vec|\\vec OpenBrace|{ Word|n CloseBrace|}"},
    {"s_\\alpha", "Word|s Underscore|_ Macro|\\alpha"},
};
INSTANTIATE_TEST_SUITE_P(Names, Lexer, testing::ValuesIn(kNames));

constexpr Case kOperators[] = {
    {"+-*/^=_,", "Plus|+ Minus|- Multiply|* Divide|/ Caret|^ Equals|= Underscore|_ Comma|,"},
    {"()[]{}", "OpenParen|( CloseParen|) OpenBracket|[ CloseBracket|] OpenBrace|{ CloseBrace|}"},
    {"a\\cdot b\\times c", "Word|a Multiply|\\cdot Word|b Cross|\\times Word|c"},
    {"\\frac\\sqrt\\exp\\max", "Frac|\\frac Sqrt|\\sqrt Function|\\exp Extremum|\\max"},
    {"\\expx", "Macro|\\expx"},
    {"&", "Ampersand|&"},
};
INSTANTIATE_TEST_SUITE_P(Operators, Lexer, testing::ValuesIn(kOperators));

constexpr Case kNothing[] = {
    {"", ""},
    {"a\\,\\;\\:\\!\\quad\\qquad~\\ b", "Word|a Gap|\\quad Gap|\\qquad Word|b"},
    {"\\left(\\right)", "OpenParen|( CloseParen|)"},
    {"\\label{eq:1}\\nonumber\\notag\\tag{3}\\tag*{a{b}}\\displaystyle 1", "Number|1"},
    {"a \\\\ b \\\\[2pt] c \\\\* d", "Word|a NewRow|\\\\ Word|b NewRow|\\\\[2pt] Word|c NewRow|\\\\* Word|d"},
    {"\\\\[2", "NewRow|\\\\ OpenBracket|[ Number|2"},
    {"\\label{a", "OpenBrace|{ Word|a"},
    {"\\label 1", "Number|1"},
    {"a % b\nc", "Word|a Word|c"},
    {"a % b\rc", "Word|a Word|c"},
    {"a\r\n\tb\\\nc", "Word|a Word|b Word|c"},
    {"\\begin{comment}x\\end{comment}1", "Number|1"},
};
INSTANTIATE_TEST_SUITE_P(Nothing, Lexer, testing::ValuesIn(kNothing));

constexpr Case kLayout[] = {
    {"\\{a\\}", "OpenSet|\\{ Word|a CloseSet|\\}"},
    {"\\left. a \\right\\}", "Word|a CloseSet|\\}"},
    {"\\bigl(a\\Bigr)", "OpenParen|( Word|a CloseParen|)"},
    {"a;b", "Word|a Comma|; Word|b"},
    {"a:=b", "Word|a Equals|:= Word|b"},
    {"a\\approx b<c\\le d", "Word|a Equals|\\approx Word|b Relation|< Word|c Relation|\\le Word|d"},
    {"\\begin{aligned}[t]a&b\\\\c\\end{aligned}&d", "Word|a Gap|& Word|b NewRow|\\\\ Word|c Ampersand|& Word|d"},
    {"\\begin{alignedat}{2}a\\end{alignedat}", "Word|a"},
    {"\\begin{gathered}a&b\\end{gathered}", "Word|a Ampersand|& Word|b"},
};
INSTANTIATE_TEST_SUITE_P(Layout, Lexer, testing::ValuesIn(kLayout));

constexpr Case kUnknown[] = {
    {"a?b", "Word|a Unknown|? Word|b"},
    {"\\verb|}%\\end{equation}|+1", "Unknown|\\verb|}%\\end{equation}| Plus|+ Number|1"},
    {"\\verb*{p} + 1\n+ 2", "Unknown|\\verb*{p} + 1 Plus|+ Number|2"},
    {"\\verb", "Unknown|\\verb"},
    {"\\verbose", "Macro|\\verbose"},
    {"é", "Unknown|é"},
    {"𝑓", "Unknown|𝑓"},
    {"\\?", "Unknown|\\?"},
    {"\\é", "Unknown|\\é"},
    {"\\", "Unknown|\\"},
    {"\xFF\xE2\x82", "Unknown|\xFF Unknown|\xE2 Unknown|\x82"},
    {"$", "Unknown|$"},
    {"\\begin{tabular}a\\end{tabular}1", "Unknown|\\begin{tabular}a\\end{tabular} Number|1"},
    {"\\begin{x}\\begin{x}\\end{x}\\end{x}1", "Unknown|\\begin{x}\\begin{x}\\end{x}\\end{x} Number|1"},
    {"\\begin{tabular}1", "Unknown|\\begin{tabular} Number|1"},
    {"\\begin 1", "Unknown|\\begin Number|1"},
};
INSTANTIATE_TEST_SUITE_P(Unknown, Lexer, testing::ValuesIn(kUnknown));

TEST(LexerComments, are_kept_apart) {
  const std::string_view text = "m = 0.3 % range [0, 1]\r\n+ 1 %";
  const auto size = static_cast<uint32_t>(text.size());
  const LexedContent content = lex(text, {0, size}, false, {size, size});
  ASSERT_EQ(content.comments.size(), 2u);
  EXPECT_EQ(text.substr(content.comments[0].begin, content.comments[0].size()), "% range [0, 1]");
  EXPECT_EQ(content.comments[1], (Span{size - 1, size}));
}

TEST(LexerTokens, follow_each_other_in_any_bytes) {
  test::Random random(7);
  for (int round = 0; round < 2000; ++round) {
    std::string bytes;
    constexpr std::string_view kPieces[] = {"\\", "text", "{",    "}", "\\begin{x}", "\\end{x}", "%", "\n", "1",
                                            ".",  "e-",   "\xFF", "ω", "&",          "\\label",  "[", " "};
    for (int i = 0; i < 30; ++i) bytes += kPieces[random.below(std::size(kPieces))];
    const auto size = static_cast<uint32_t>(bytes.size());
    const LexedContent content = lex(bytes, {0, size}, false, {size, size});
    uint32_t at = 0;
    for (const Token& token : content.tokens) {
      EXPECT_GE(token.span.begin, at);
      EXPECT_GE(token.span.end, token.span.begin);
      at = token.span.end;
    }
    EXPECT_EQ(at, size);
  }
}

TEST(ControlWords, find_all_commands_and_nothing_else) {
  EXPECT_EQ(find_command("arccos"), Command::Arccos);
  EXPECT_EQ(find_command("times"), Command::Times);
  EXPECT_EQ(find_command("alpha"), Command::None);
  EXPECT_EQ(find_command("left"), Command::None);
  EXPECT_EQ(find_command(""), Command::None);
#define COMMAND(name, spelling, category)           \
  EXPECT_EQ(find_command(spelling), Command::name); \
  EXPECT_EQ(command_spelling(Command::name), spelling);
#include "syntax/commands.def"
#undef COMMAND
}

}  // namespace
}  // namespace texbrdf
