#include <gtest/gtest.h>

#include <set>

#include "support/parse_equation.h"

namespace texbrdf {
namespace {

struct Case {
  const char* equation;
  const char* problems;  ///< code and underlined text of each
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.equation;
}

class ParserProblems : public testing::TestWithParam<Case> {};

TEST_P(ParserProblems, underlines) {
  EXPECT_EQ(test::diagnostics_text(test::parse_equation(GetParam().equation)), GetParam().problems);
}

constexpr Case kCharacters[] = {
    {"f=1?2", "E1001 [?]"},
    {"f=?", "E1001 [?]"},
    {"f=???1", "E1001 [?]"},
    {"f=1+?+?", "E1001 [?] E1001 [?]"},
    {"f=été", "E1001 [é]"},
    {"f=\\{1\\}", ""},
    {"f=\\[1", "E1001 [\\[]"},
    {"f=1.", ""},
    {"f=1.+2", "E1001 [.]"},
    {"f=$1$", "E1001 [$]"},
    {"f=x_{a?b}", "E1001 [?]"},
    {"f=x_?", "E1001 [?]"},
    {"f=\\vec{.,1,2}", "E1001 [.]"},
    {"f=1+\xFF", "E1002 [\xFF]"},
    {"f&=1&", "E1003 [&] E1003 [&]"},
    {"f=\\text", "E1004 [\\text]"},
    {"f=\\mathrm 1", "E1004 [\\mathrm]"},
    {"f=\\text{a", "E2003 [{]"},
    {"f=\\text{}", "E1005 [\\text{}]"},
    {"f=\\text{ }", "E1005 [\\text{ }]"},
    {"f=\\begin{tabular} a & b \\\\ c \\end{tabular}", "E1006 [\\begin{tabular}]"},
};
INSTANTIATE_TEST_SUITE_P(Characters, ParserProblems, testing::ValuesIn(kCharacters));

constexpr Case kExpressions[] = {
    {"", "E2001 [\\end]"},
    {" % only a comment\n", "E2001 [\\end]"},
    {"f=", "E2001 [\\end]"},
    {"f=1+", "E2001 [\\end]"},
    {"f=---", "E2001 [\\end]"},
    {"f=*2", "E2001 [*]"},
    {"f=1+*2", "E2001 [*]"},
    {"f=1+*2+*3", "E2001 [*] E2001 [*]"},
    {"f=\\sqrt 42", "E2023 [2]"},
    {"f=\\frac{1}234 + \\frac123", "E2023 [34] E2023 [3]"},
    {"f=\\sqrt 4 2 + \\frac12 3", ""},
    {"f=\\sqrt{4}2", ""},
    {"f=4 2", "E3012 [2]"},
    {"f=\\mathop{max}(1, 2)+\\mathop{\\rm min}(1,2)", ""},
    {"f=2·x×3−n.l", ""},
    {"f=a. b", "E1001 [.]"},
    {"f=a.\\text{ where }b=1", ""},
    {"f=a\\\\b + c\\\\(d\\\\e)", "E2024 [b] E2024 [e]"},
    {"f=a\\\\\\times b\\\\+c", ""},
    {"a_{\\{v,l\\}}=1", "E2025 [a_{\\{v,l\\}}]"},
    {"f=()", "E2001 [)]"},
    {"f=g()", "E2001 [)]"},
    {"f=g(1,)", "E2001 [)]"},
    {"f=g(,1)", "E2001 [,]"},
    {"f={}", "E2001 [}]"},
    {"f=\\frac{}{2}", "E2001 [}]"},
    {"f=\\sqrt", "E2001 [\\end]"},
    {"f=\\sin+", "E2001 [\\end]"},
    {"f=\\sin^+ x", "E2001 [+]"},
    {"f=[1]", ""},
    {"f=[]", "E2001 []]"},
    {"f=2 3", "E3012 [3]"},
    {"f=2 3+4 5", "E3012 [3] E3012 [5]"},
    {"f=\\sinh^{-1}x", "E2021 [^]"},
    {"f=_1", "E2001 [_]"},
    {"f=1,2", "E2002 [,]"},
    {"f={1,2}", "E2002 [,]"},
    {"f={1,2}+{3,4}", "E2002 [,] E2002 [,]"},
    {"f=(1,,2)", "E2001 [,]"},
    {"f=(1,2,)+(,3,4)", "E2001 [)] E2001 [,]"},
    {"f=a=b", ""},
    {"f=a,b", "E2002 [,]"},
    {"f=a[1]", ""},
    {"f=1_2", "E2002 [_]"},
    {"f=(1)_2", "E2002 [_]"},
    {"f=\\vec{a+b}", "E2002 [+]"},
    {"f=\\vec{}", "E2018 [}]"},
    {"f=\\vec{(a)}", "E2018 [(]"},
    {"f=\\vec+1", "E2016 [+]"},
    {"f=\\frac12", ""},
    {"f=\\frac{1}2", ""},
    {"f=\\frac", "E2016 [\\end]"},
    {"f=\\max x", "E2016 [x]"},
    {"f=\\max", "E2016 [\\end]"},
};
INSTANTIATE_TEST_SUITE_P(Expressions, ParserProblems, testing::ValuesIn(kExpressions));

constexpr Case kBrackets[] = {
    {"f=((1*2)", "E2003 [(]"},      {"f=2^{1+3", "E2003 [{]"},
    {"f=\\left(1+2", "E2003 [(]"},  {"f=(", "E2003 [(]"},
    {"f=((({", "E2003 [(]"},        {"f=(1+2]*3", "E2003 [(]"},
    {"f=(1+2}", "E2003 [(]"},       {"f=(a+{b)+c}", "E2003 [{]"},
    {"f=\\sqrt[3 x", "E2003 [[]"},  {"f=\\max((1,2)", "E2003 [(]"},
    {"f=\\frac{1{2}", "E2003 [{]"}, {"f=g(1,", "E2003 [(]"},
    {"f=(1,2", "E2003 [(]"},        {"f=(1,2]", "E2003 [(]"},
    {"f=x_{a", "E2003 [{]"},        {"f=\\vec{1,2,3", "E2003 [{]"},
    {"f=\\vec{n", "E2003 [{]"},     {"f=\\label{a", "E2003 [{]"},
    {"f=1+2)", "E2004 [)]"},        {"f=)", "E2004 [)]"},
    {"f=1+)", "E2004 [)]"},         {"f=1)+2}", "E2004 [)] E2004 [}]"},
    {"f=(1}+2)", "E2004 [}]"},      {"f=1)+?", "E2004 [)] E1001 [?]"},
    {"f(x=3", "E2003 [(]"},
};
INSTANTIATE_TEST_SUITE_P(Brackets, ParserProblems, testing::ValuesIn(kBrackets));

constexpr Case kDefinitions[] = {
    {"1 + 2 = f", "E2007 [1 + 2]"},
    {"f(1)=2", "E2007 [f(1)]"},
    {"a,b=1", "E2007 [a,b]"},
    {"(f)=1", "E2007 [(f)]"},
    {"-f=1", "E2007 [-f]"},
    {"x^2=1", "E2036 [x^2]"},
    {"2x=1", "E2007 [2x]"},
    {"f(x)(y)=1", "E2007 [f(x)(y)]"},
    {"\\vec{1,2,3}=1", "E2007 [\\vec{1,2,3}]"},
    {"\\max(a,b)=1", "E2007 [\\max(a,b)]"},
    {"f(g(x))=1", "E2007 [f(g(x))]"},
    {"1=2=3", "E2007 [1]"},
    {"1+2=?", "E1001 [?]"},
    {"=3", "E2001 [=]"},
    {"f()=3", "E2001 [)]"},
    {"x", "E2008 [\\end]"},
    {"1+2", "E2008 [\\end]"},
    {"f,1", "E2002 [,]"},
    {"a_b_c=1", "E2014 [_]"},
    {"f=a_b_c_d", "E2014 [_]"},
    {"f=x_{a_b_c}", "E2014 [_]"},
    {"f=x_{_a}", "E2018 [_]"},
    {"f=x_", "E2015 [\\end]"},
    {"f=x_,", "E2015 [,]"},
    {"f=x_{}", "E2015 [}]"},
};
INSTANTIATE_TEST_SUITE_P(Definitions, ParserProblems, testing::ValuesIn(kDefinitions));

constexpr Case kVectors[] = {
    {"f=\\vec{1,2}", "E2009 [\\vec{1,2}]"},
    {"f=\\vec{1}", "E2009 [\\vec{1}]"},
    {"f=\\vec{1,2,3,4} + \\vec{ 1 }", "E2009 [\\vec{1,2,3,4}] E2009 [\\vec{ 1 }]"},
    {"f=\\vec{1,x,3}", "E2010 [x]"},
    {"f=\\vec{1,-x,2*3}", "E2010 [-x] E2010 [2*3]"},
    {"f=\\vec{1,x+,3}", "E2001 [,]"},
    {"f=\\vec{-1,+.5,-+2}", ""},
};
INSTANTIATE_TEST_SUITE_P(Vectors, ParserProblems, testing::ValuesIn(kVectors));

constexpr Case kReadings[] = {
    {"a=2^3^2", "E2012 [^]"},
    {"a=2^3^2^1", "E2012 [^]"},
    {"a=2^{3^2}", ""},
    {"a=2^-3^2", ""},
    {"a=\\exp 2^3^2", "E2013 [^] E2012 [^]"},
    {"a=\\ln\\alpha^2", "E2013 [^]"},
    {"a=\\exp -2^2", "E2013 [^]"},
    {"a=\\cos(x)^2", ""},
    {"a=\\cos{x}^2", ""},
    {"a=\\cos{x^2}", ""},
    {"a=\\sqrt 4^8", ""},
    {"a=2x", ""},
    {"a=\\foo{1}", ""},
};
INSTANTIATE_TEST_SUITE_P(Readings, ParserProblems, testing::ValuesIn(kReadings));

std::string last_token(std::string_view equation) {
  const ParsedBlock block = test::parse_equation(equation);
  const Span span = block.diagnostics.at(0).where.span;
  return std::to_string(span.begin - block.extent.content.begin);
}

TEST(ParserProblemPlaces, are_those_of_the_documented_operator) {
  EXPECT_EQ(last_token("f = ((1 * 2)"), "4");  // the outermost
  EXPECT_EQ(last_token("a=2^3^2"), "5");       // the second power
  EXPECT_EQ(last_token("a=2^3^2^1"), "7");     // the last of the chain
  EXPECT_EQ(last_token("a=(1)+(2"), "6");
}

TEST(ParserProblemNotes, name_the_token_found_instead_of_a_closer) {
  const ParsedBlock block = test::parse_equation("f = (1 + 2] * 3");
  ASSERT_EQ(block.diagnostics.size(), 1u);
  ASSERT_EQ(block.diagnostics[0].related.size(), 1u);
  EXPECT_EQ(block.slice(block.diagnostics[0].related[0].where.span), "]");
  EXPECT_EQ(block.diagnostics[0].related[0].message, "found `]` instead of `)`");
}

TEST(ParserProblemNotes, name_both_readings_of_a_power) {
  const ParsedBlock block = test::parse_equation("f = \\ln\n \\alpha^2");
  ASSERT_EQ(block.diagnostics.size(), 1u);
  EXPECT_EQ(message(block.diagnostics[0]),
            "read as `\\ln(\\alpha^2)`; write `(\\ln \\alpha)^2` for the power of the function's value");
}

std::string apply(const ParsedBlock& block, const Fix& fix) {
  std::string text(block.text);
  for (auto edit = fix.edits.rbegin(); edit != fix.edits.rend(); ++edit) {
    text.replace(edit->where.span.begin, edit->where.span.size(), edit->replacement);
  }
  return text;
}

TEST(ParserFixes, leave_nothing_to_report) {
  for (const char* equation : {"f=((1*2)", "f=2^{1+3", "f=1+2)", "f=(1+2)*3}", "f&=1", "f=2^3^2", "f=\\ln\\alpha^2",
                               "f=\\exp -2^2", "f=\\sin\\cos x^2", "f=x_{a", "f=(a+{b)"}) {
    const ParsedBlock block = test::parse_equation(equation);
    ASSERT_EQ(block.diagnostics.size(), 1u) << equation;
    ASSERT_FALSE(block.diagnostics[0].fixes.empty()) << equation;
    for (const Fix& fix : block.diagnostics[0].fixes) {
      const std::string mended = apply(block, fix);
      EXPECT_EQ(test::diagnostics_text(test::parse_first_block(mended)), "") << mended;
    }
  }
}

TEST(ParserBrokenBlocks, give_the_one_error_at_begin) {
  struct Document {
    const char* text;
    const char* problems;
    bool readable;
  };
  constexpr Document kDocuments[] = {
      {"\\begin{equation}\na = 1\n\nprose", "E2005 [\\begin{equation}]", true},
      {"\\begin{equation*}a = 1", "E2005 [\\begin{equation*}]", true},
      {"\\begin{equation}a = 1\\end{document}", "E2005 [\\begin{equation}]", true},
      {"\\begin{equation}a = 1\\end{equation*}", "E2006 [\\begin{equation}]", true},
      {"\\begin{equation}a = 1 \\begin{equation}b=1\\end{equation}", "E2005 [\\begin{equation}]", true},
      {"\\begin{equation}a = (1 & ; \n\n", "E2005 [\\begin{equation}]", false},
      {"\\begin{equation}a = 1\nprose follows", "E2005 [\\begin{equation}]", false},
  };
  for (const Document& document : kDocuments) {
    const ParsedBlock block = test::parse_first_block(document.text);
    EXPECT_EQ(test::diagnostics_text(block), document.problems) << document.text;
    ASSERT_EQ(block.definitions.size(), 1u) << document.text;
    EXPECT_EQ(block.definitions[0].readable, document.readable) << document.text;
  }
}

TEST(ParserBrokenBlocks, are_mended_by_their_fixes) {
  for (const char* document : {"\\begin{equation}\na = 1 % one\n\nprose", "\\begin{equation*}a = 1\\end{equation}"}) {
    const ParsedBlock block = test::parse_first_block(document);
    ASSERT_EQ(block.diagnostics.size(), 1u);
    const ParsedBlock mended = test::parse_first_block(apply(block, block.diagnostics[0].fixes.at(0)));
    EXPECT_EQ(test::diagnostics_text(mended), "") << mended.text;
    EXPECT_TRUE(mended.definitions.at(0).readable);
  }
}

TEST(ParserBrokenBlocks, keep_the_name_of_what_cannot_be_read) {
  for (const char* equation : {"f=", "f=1+2)", "f=?", "f(x)=(x", "f=a,b", "f=\\vec{1,2}", "f=x_"}) {
    const ParsedBlock block = test::parse_equation(equation);
    ASSERT_EQ(block.definitions.size(), 1u) << equation;
    EXPECT_EQ(block.node_text(block.definitions[0].name), "f") << equation;
    EXPECT_FALSE(block.definitions[0].readable) << equation;
    EXPECT_EQ(block.tree.node(block.definitions[0].body).kind, NodeKind::Error) << equation;
  }
}

TEST(ParserBrokenBlocks, that_are_too_long_are_one_error) {
  const ParsedBlock block = test::parse_equation("f=1" + std::string(kMaxBlockBytes, ' '));
  EXPECT_EQ(test::diagnostics_text(block), "E2017 [\\begin{equation}]");
  EXPECT_TRUE(block.definitions.empty());
}

}  // namespace
}  // namespace texbrdf
