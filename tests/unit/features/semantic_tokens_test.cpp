#include "features/semantic_tokens.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "analysis/document.h"

namespace texbrdf::features {
namespace {

std::string equation(std::string_view content) {
  return "\\begin{equation}" + std::string(content) + "\\end{equation}\n";
}

std::string shown(const Snapshot& snapshot, const SemanticToken& token) {
  std::string text(snapshot.text().slice(token.span));
  text += ":" + std::string(semantic_type_names()[static_cast<std::size_t>(token.type)]);
  for (std::size_t i = 0; i < semantic_modifier_names().size(); ++i) {
    if ((token.modifiers >> i & 1) != 0) text += "." + std::string(semantic_modifier_names()[i]);
  }
  return text;
}

/// All tokens as `text:type.modifier`, a space between them.
std::string tokens_of(const std::string& document) {
  Document opened(document);
  const Snapshot& snapshot = opened.snapshot();
  std::string text;
  for (const SemanticToken& token : semantic_tokens(snapshot, {0, snapshot.text().size()})) {
    text += (text.empty() ? "" : " ") + shown(snapshot, token);
  }
  return text;
}

TEST(SemanticTokens, NamesNumbersOperatorsAndCommands) {
  EXPECT_EQ(tokens_of(equation("a_{1} = \\frac{\\rho_d}{\\pi} * .5")),
            "a_{1}:variable.definition =:operator \\frac:keyword \\rho_d:variable \\pi:variable.defaultLibrary "
            "*:operator .5:number");
  EXPECT_EQ(tokens_of(equation("f = \\max(\\cos\\theta_i^2, -\\sqrt{\\vec{n} \\cdot \\vec{1, 0, 0}}/2)")),
            "f:variable.definition =:operator \\max:keyword \\cos:keyword \\theta_i:variable.defaultLibrary ^:operator "
            "2:number -:operator \\sqrt:keyword \\vec{n}:variable.defaultLibrary \\cdot:operator \\vec:keyword "
            "1:number 0:number 0:number /:operator 2:number");
}

TEST(SemanticTokens, CasesAndConditions) {
  EXPECT_EQ(tokens_of(equation("f = \\begin{cases} 1 & \\text{if } x \\le 2 \\land y > 0 \\\\ 0 \\end{cases}")),
            "f:variable.definition =:operator \\begin{cases}:keyword 1:number \\text{if }:keyword x:variable "
            "\\le:operator 2:number \\land:operator y:variable >:operator 0:number 0:number \\end{cases}:keyword");
  EXPECT_EQ(tokens_of(equation("f = \\chi^+(x)")), "f:variable.definition =:operator \\chi^+:function x:variable");
}

TEST(SemanticTokens, FunctionsAndTheirParameters) {
  EXPECT_EQ(tokens_of(equation("g(x, \\vec{v}) = x * \\vec{v} + y") + equation("f = g(1, \\text{dir})")),
            "g:function.definition x:parameter.declaration \\vec{v}:parameter.declaration =:operator x:parameter "
            "*:operator \\vec{v}:parameter +:operator y:variable f:variable.definition =:operator g:function 1:number "
            "\\text{dir}:variable");
}

TEST(SemanticTokens, AParameterIsOneOnlyInItsFunction) {
  EXPECT_EQ(tokens_of(equation("g(x) = x") + equation("h = x")),
            "g:function.definition x:parameter.declaration =:operator x:parameter h:variable.definition =:operator "
            "x:variable");
}

TEST(SemanticTokens, ADefinitionOrParameterHidesAConvention) {
  EXPECT_EQ(tokens_of(equation("\\theta_h = 1") + equation("f = \\theta_h + \\vec{\\omega_i}*\\vec{h}")),
            "\\theta_h:variable.definition =:operator 1:number f:variable.definition =:operator \\theta_h:variable "
            "+:operator \\vec{\\omega_i}:variable.defaultLibrary *:operator \\vec{h}:variable.defaultLibrary");
  EXPECT_EQ(tokens_of(equation("g(\\omega_i) = \\omega_i*\\omega_o")),
            "g:function.definition \\omega_i:parameter.declaration =:operator \\omega_i:parameter *:operator "
            "\\omega_o:variable.defaultLibrary");
  EXPECT_EQ(tokens_of(equation("\\pi = 3") + equation("f = \\pi")),
            "\\pi:variable.definition =:operator 3:number f:variable.definition =:operator "
            "\\pi:variable.defaultLibrary");
}

TEST(SemanticTokens, ABrokenBlockKeepsItsTokens) {
  EXPECT_EQ(tokens_of(equation("g(x) = 2 * (x")),
            "g:function.definition x:parameter.declaration =:operator 2:number *:operator x:parameter");
  EXPECT_EQ(tokens_of(equation("a + 1")), "a:variable +:operator 1:number");
}

TEST(SemanticTokens, NothingOutsideMathAndInComments) {
  EXPECT_EQ(tokens_of("a = 1 $b < 2$ % c = 3\n" + equation("d % e = 4\n = 5") + "\\begin{verbatim}" +
                      equation("g = 6") + "\\end{verbatim}"),
            "d:variable.definition =:operator 5:number");
  EXPECT_EQ(tokens_of("prose"), "");
}

TEST(SemanticTokens, ANameOverSeveralLinesIsATokenOnEach) {
  EXPECT_EQ(tokens_of(equation("x_{a\r\n  b} = 1")),
            "x_{a:variable.definition b}:variable.definition =:operator 1:number");
}

TEST(SemanticTokens, ARangeHasWhatItTouches) {
  Document opened("prose\n" + equation("a = 1") + equation("bcd = 22") + equation("e = 3"));
  const Snapshot& snapshot = opened.snapshot();
  const auto text = snapshot.text().slice({0, snapshot.text().size()});
  const auto begin = static_cast<uint32_t>(text.find("cd"));
  const auto end = static_cast<uint32_t>(text.find("22") + 1);
  std::string found;
  for (const SemanticToken& token : semantic_tokens(snapshot, {begin, end})) found += shown(snapshot, token) + " ";
  EXPECT_EQ(found, "bcd:variable.definition =:operator 22:number ");
  EXPECT_TRUE(semantic_tokens(snapshot, {0, 3}).empty());
}

TEST(SemanticTokens, ManyParametersAndUsesTakeNoTime) {
  std::string parameters = "x_0";
  std::string sum = "x_0";
  for (int i = 1; i < 20000; ++i) {
    parameters += ",x_{" + std::to_string(i) + "}";
    sum += "+x_{" + std::to_string(i) + "}";
  }
  const std::string document = equation("g(" + parameters + ") = " + sum);
  Document opened(document);
  const Snapshot& snapshot = opened.snapshot();
  EXPECT_EQ(semantic_tokens(snapshot, {0, snapshot.text().size()}).size(), 1u + 20000 + 1 + 20000 + 19999);
}

}  // namespace
}  // namespace texbrdf::features
