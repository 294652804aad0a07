#include "features/signature_help.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "analysis/document.h"

namespace texbrdf::features {
namespace {

constexpr std::string_view kModel =
    "\\begin{equation}g(m, \\vec{t}) = m * \\vec{t}\\end{equation}\n"
    "\\begin{equation}h(x) = 2 * x\\end{equation}\n"
    "\\begin{equation}\\text{D}_1(\\omega_i) = \\cos\\theta_i\\end{equation}\n"
    "\\begin{equation}k = 1\\end{equation}\n";

/// The label with the active parameter in brackets, at the `@` of a right side.
std::string help(std::string_view right) {
  std::string text = std::string(kModel) + "\\begin{equation}f = " + std::string(right) + "\\end{equation}\n";
  const std::size_t at = text.find('@');
  text.erase(at, 1);
  Document document(text);
  const auto found = signature_help(document.snapshot(), static_cast<uint32_t>(at), Markup::PlainText);
  if (!found) return "nothing";
  std::string label = found->label;
  if (found->active >= found->parameters.size()) return label;
  const Span active = found->parameters[found->active];
  return label.insert(active.end, "]").insert(active.begin, "[");
}

TEST(SignatureHelp, MarksTheParameterOfTheCaret) {
  EXPECT_EQ(help("g(@)"), "g([m: ℝ], \\vec{t}: ℝ³): ℝ³");
  EXPECT_EQ(help("g(1@, \\vec{n})"), "g([m: ℝ], \\vec{t}: ℝ³): ℝ³");
  EXPECT_EQ(help("g(1, @)"), "g(m: ℝ, [\\vec{t}: ℝ³]): ℝ³");
  EXPECT_EQ(help("g(1, \\vec{n}@)"), "g(m: ℝ, [\\vec{t}: ℝ³]): ℝ³");
  EXPECT_EQ(help("g(1, \\vec{n}, @)"), "g(m: ℝ, \\vec{t}: ℝ³): ℝ³");
  EXPECT_EQ(help("g(1, \\vec{1, 0, 0@})"), "g(m: ℝ, [\\vec{t}: ℝ³]): ℝ³");
  EXPECT_EQ(help("g(\\max(1, 2), @)"), "g(m: ℝ, [\\vec{t}: ℝ³]): ℝ³");
  EXPECT_EQ(help("\\text{D}_{1}(@)"), "\\text{D}_1([\\omega_i: ℝ³]): ℝ");
}

TEST(SignatureHelp, IsOfTheInnermostCall) {
  EXPECT_EQ(help("g(h(@), \\vec{n})"), "h([x: ℝ]): ℝ");
  EXPECT_EQ(help("g(h(1)@, \\vec{n})"), "g([m: ℝ], \\vec{t}: ℝ³): ℝ³");
  EXPECT_EQ(help("g(h(1), 2 * (1 + @"), "g(m: ℝ, [\\vec{t}: ℝ³]): ℝ³");
  EXPECT_EQ(help("h(\\frac{1}{@})"), "h([x: ℝ]): ℝ");
  EXPECT_EQ(help("h(\\exp(@))"), "h([x: ℝ]): ℝ");
  EXPECT_EQ(help("h(\\max(1, @))"), "\\max(x_1: ℝ, [x_2: ℝ], …): ℝ");
  EXPECT_EQ(help("\\min{1, 2, @}"), "\\min(x_1: ℝ, x_2: ℝ, [x_3: ℝ], …): ℝ");
}

TEST(SignatureHelp, HoldsInBrokenEquations) {
  EXPECT_EQ(help("g(@"), "g([m: ℝ], \\vec{t}: ℝ³): ℝ³");
  EXPECT_EQ(help("1 + * ) g(1, @"), "g(m: ℝ, [\\vec{t}: ℝ³]): ℝ³");
  EXPECT_EQ(help("g(nowhere, @"), "g(m: ℝ, [\\vec{t}: ℝ³]): ℝ³");
  EXPECT_EQ(help("a = g(@"), "g([m: ℝ], \\vec{t}: ℝ³): ℝ³");
}

TEST(SignatureHelp, IsNothingElsewhere) {
  for (const char* right : {"@g(1, \\vec{n})", "g@(1, \\vec{n})", "g(1, \\vec{n})@", "k(@)", "nowhere(@)", "2 * (@)",
                            "\\exp(@)", "g(1, % @\n \\vec{n})"}) {
    EXPECT_EQ(help(right), "nothing") << right;
  }
  EXPECT_EQ(help("1\\end{equation} g(@ \\begin{equation}b = 1"), "nothing");
}

TEST(SignatureHelp, IsNothingWhereAFunctionIsDefined) {
  Document document("\\begin{equation}g(x) = x\\end{equation}");
  EXPECT_FALSE(signature_help(document.snapshot(), 18, Markup::PlainText));
}

TEST(SignatureHelp, SaysTheEquation) {
  Document document("\\begin{equation}g(x) = 2*x\\end{equation}\\begin{equation}f = g(\\end{equation}");
  const auto at = static_cast<uint32_t>(document.text().size() - std::string_view("\\end{equation}").size());
  const auto found = signature_help(document.snapshot(), at, Markup::PlainText);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->documentation, "g: ℝ → ℝ\n\ng(x) = 2*x\n\ndefined on line 1");
}

}  // namespace
}  // namespace texbrdf::features
