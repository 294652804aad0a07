#include "features/code_actions.h"

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

std::vector<CodeAction> all_actions(Document& document) {
  return code_actions(document.snapshot(), {0, document.text().size()});
}

std::string titles(const std::vector<CodeAction>& actions) {
  std::string text;
  for (const CodeAction& action : actions) {
    text += (text.empty() ? "" : ", ") + action.title + (action.is_preferred ? " !" : "");
  }
  return text;
}

std::string applied(const std::string& text, const CodeAction& action) {
  std::string result = text;
  for (auto edit = action.edits.rbegin(); edit != action.edits.rend(); ++edit) {
    result.replace(edit->span.begin, edit->span.size(), edit->text);
  }
  return result;
}

/// Applies the action with this title.
std::string mended(const std::string& text, std::string_view title) {
  Document document(text);
  for (const CodeAction& action : all_actions(document)) {
    if (action.title == title) return applied(text, action);
  }
  return "no such action: " + titles(all_actions(document));
}

/// All but hints, such as that nothing uses a parameter.
std::string problems(const std::string& text) {
  Document document(text);
  std::string found;
  for (const ShownDiagnostic& diagnostic : diagnostics(document.snapshot(), nullptr)) {
    if (diagnostic.severity != Severity::Hint) found += diagnostic.message + "\n";
  }
  return found;
}

struct Mend {
  std::string text;
  const char* title;
  std::string mended;
};

TEST(CodeActions, DoNotTurnDirectionsIntoTuples) {
  for (const char* expression :
       {"\\vec{n} + 1", "\\exp(\\vec{1, 0, 0} \\times \\vec{n})", "(\\vec{1, 0, 0} + \\omega_i) - 1"}) {
    Document document(equation("f = " + std::string(expression)));
    EXPECT_EQ(titles(all_actions(document)), "") << expression;
  }
}

TEST(CodeActions, MendWhatTheyAreFor) {
  const Mend mends[] = {
      {equation("a = 1") + equation("f = a*pi"), "replace by `\\pi`", equation("a = 1") + equation("f = a*\\pi")},
      {equation("f = \\sine(1)"), "replace by `\\sin`", equation("f = \\sin(1)")},
      {equation("f = 2 3"), "insert `\\cdot`", equation("f = 2 \\cdot 3")},
      {equation("f = \\vec{n}\\vec{h}"), "insert `\\cdot`", equation("f = \\vec{n}\\cdot \\vec{h}")},
      {equation("f = 1 - \\vec{0.5, 0.2, 0.1}"), "write `(0.5, 0.2, 0.1)`, which may be a colour",
       equation("f = 1 - (0.5, 0.2, 0.1)")},
      {equation("a = \\vec{0.5, 0.2, 0.1}") + equation("f = \\exp(-2a/3)"),
       "write `(0.5, 0.2, 0.1)`, which may be a colour",
       equation("a = (0.5, 0.2, 0.1)") + equation("f = \\exp(-2a/3)")},
      {equation("a = \\vec{1, 0, 0}") + equation("f = a a"), "write `(1, 0, 0)`, which may be a colour",
       equation("a = (1, 0, 0)") + equation("f = a a")},
      {equation("f = \\frac{1}{\\vec{1,0,0} + \\vec{0,1,1}}"),
       "write tuples `(…)` for `\\vec{…}`, which may be colours", equation("f = \\frac{1}{(1,0,0) + (0,1,1)}")},
      {equation("w = (0.2, 0.7, 0.1)") + equation("f = (1, 0.5, x_1) \\cdot w") + equation("x_1 = 2"),
       "write `*`, a product by component",
       equation("w = (0.2, 0.7, 0.1)") + equation("f = (1, 0.5, x_1) * w") + equation("x_1 = 2")},
      {equation("w = (0.2, 0.7, 0.1)") + equation("f = (1, 0.5, x_1) \\cdot w") + equation("x_1 = 2"),
       "write `\\vec{0.2, 0.7, 0.1}` for the dot product",
       equation("w = \\vec{0.2, 0.7, 0.1}") + equation("f = (1, 0.5, x_1) \\cdot w") + equation("x_1 = 2")},
      {equation("f = 1/4\\pi"), "put all of it below the line", equation("f = 1/(4\\pi)")},
      {equation("f = 1/4\\pi"), "put the quotient in parentheses", equation("f = (1/4)\\pi")},
      {equation("f = \\cos\\pi\\theta_i"), "put the operand in parentheses", equation("f = \\cos(\\pi\\theta_i)")},
      {equation("f = \\cos\\pi\\theta_i"), "end the operand before this", equation("f = (\\cos\\pi)\\theta_i")},
      {equation("f = exp(1)"), "write `\\exp`", equation("f = \\exp(1)")},
      {equation("f = (1 + 2"), "insert `)`", equation("f = (1 + 2)")},
      {equation("f = 1 + 2)"), "remove `)`", equation("f = 1 + 2")},
      {equation("f = 2^3^2"), "put the exponent in braces", equation("f = 2^{3^2}")},
      {equation("f &= 1"), "remove `&`", equation("f = 1")},
      {"\\begin{equation}f = 1\n\nprose", "insert `\\end{equation}`",
       "\\begin{equation}f = 1\n\\end{equation}\n\nprose"},
      {equation("g(x) = x \\times \\vec{n}") + equation("f = g(\\vec{h})"), "write `\\vec{x}`",
       equation("g(\\vec{x}) = \\vec{x} \\times \\vec{n}") + equation("f = g(\\vec{h})")},
  };
  for (const Mend& mend : mends) {
    EXPECT_EQ(mended(mend.text, mend.title), mend.mended);
    EXPECT_EQ(problems(mend.mended), "");
  }
}

TEST(CodeActions, DefineTheMissingName) {
  const Mend definitions[] = {
      {"\\begin{equation}\n  f = 2 * q\n\\end{equation}\n", "define `q` in a new equation",
       "\\begin{equation}\n  q = 1\n\\end{equation}\n\\begin{equation}\n  f = 2 * q\n\\end{equation}\n"},
      // As the block at hand is written: environment, indentation, ends of lines.
      {"  \\begin{equation*}\r\n\tf = 2 * q_{ab}\r\n  \\end{equation*}", "define `q_{ab}` in a new equation",
       "  \\begin{equation*}\r\n\tq_{ab} = 1\r\n  \\end{equation*}\r\n  \\begin{equation*}\r\n\tf = 2 * q_{ab}\r\n  "
       "\\end{equation*}"},
      {equation("f = q"), "define `q` in a new equation",
       "\\begin{equation}\n  q = 1\n\\end{equation}\n" + equation("f = q")},
      {"\\be f = q \\ee", "define `q` in a new equation", "\\be\n  q = 1\n\\ee\n\\be f = q \\ee"},
      // A value of the type that fits.
      {equation("f = \\vec{n} \\times q"), "define `q` in a new equation",
       "\\begin{equation}\n  q = \\vec{1, 1, 1}\n\\end{equation}\n" + equation("f = \\vec{n} \\times q")},
      {equation("f = q + \\vec{n}"), "define `q` in a new equation",
       "\\begin{equation}\n  q = \\vec{1, 1, 1}\n\\end{equation}\n" + equation("f = q + \\vec{n}")},
      {equation("f = \\vec{q}"), "define `\\vec{q}` in a new equation",
       "\\begin{equation}\n  \\vec{q} = \\vec{1, 1, 1}\n\\end{equation}\n" + equation("f = \\vec{q}")},
      {equation("f = \\foo_d + 1"), "define `\\foo_d` in a new equation",
       "\\begin{equation}\n  \\foo_d = 1\n\\end{equation}\n" + equation("f = \\foo_d + 1")},
      // A function where it is called.
      {equation("f = q(1, \\vec{n}, \\theta_i, \\theta_i)"),
       "define `q(x_1, \\vec{n}, \\theta_i, x_4)` in a new equation",
       "\\begin{equation}\n  q(x_1, \\vec{n}, \\theta_i, x_4) = 1\n\\end{equation}\n" +
           equation("f = q(1, \\vec{n}, \\theta_i, \\theta_i)")},
      {equation("f = \\vec{n} - q((2 * \\vec{h}))"), "define `q(\\vec{x_1})` in a new equation",
       "\\begin{equation}\n  q(\\vec{x_1}) = \\vec{1, 1, 1}\n\\end{equation}\n" +
           equation("f = \\vec{n} - q((2 * \\vec{h}))")},
      // The root, below.
      {equation("a = 1"), "define `f` in a new equation",
       "\\begin{equation}a = 1\\end{equation}\n\\begin{equation}\n  f = 1\n\\end{equation}\n"},
  };
  for (const Mend& definition : definitions) {
    EXPECT_EQ(mended(definition.text, definition.title), definition.mended);
    EXPECT_EQ(problems(definition.mended), "");
  }
}

TEST(CodeActions, DoNotDefineWhatIsNoName) {
  Document document(equation("f = \\foo{1}"));
  EXPECT_EQ(titles(all_actions(document)), "");
}

TEST(CodeActions, PreferTheOnlyFix) {
  Document one(equation("rho = 1") + equation("f = rhoo"));
  EXPECT_EQ(titles(all_actions(one)), "replace by `rho` !, define `rhoo` in a new equation");
  Document two(equation("f = \\ln\\pi^2"));
  EXPECT_EQ(titles(all_actions(two)), "put the operand in parentheses, raise the function's value");
}

TEST(CodeActions, AreForTheProblemsThatTheRangeTouches) {
  const std::string text = equation("a = exp(1)") + equation("f = 2 3");
  Document document(text);
  const auto at = [&](std::size_t begin, std::size_t end) {
    return titles(code_actions(document.snapshot(), {static_cast<uint32_t>(begin), static_cast<uint32_t>(end)}));
  };
  const std::size_t word = text.find("exp");
  EXPECT_EQ(at(word, word), "write `\\exp` !");
  EXPECT_EQ(at(word + 3, word + 3), "write `\\exp` !");
  EXPECT_EQ(at(word + 4, word + 4), "");
  EXPECT_EQ(at(0, text.size()), "write `\\exp` !, insert `\\cdot` !");
}

TEST(CodeActions, CarryTheirDiagnostic) {
  Document document(equation("f = exp(1)"));
  const auto actions = all_actions(document);
  ASSERT_EQ(actions.size(), 1u);
  EXPECT_EQ(actions[0].diagnostic.code, "E2022");
  EXPECT_EQ(document.snapshot().text().slice(actions[0].diagnostic.span), "exp");
}

/// What code_actions gives at each place is what all diagnostics that touch it give.
TEST(CodeActions, OfARangeAreThoseOfTheDiagnosticsThatTouchIt) {
  const std::string block = "\\begin{equation}a = zz\\end{equation}";
  Document document(block + block + " prose\n" + block + "\\begin{equation}b = (1\\begin{equation}");
  const Snapshot& snapshot = document.snapshot();
  const std::vector<CodeAction> all = all_actions(document);
  ASSERT_GE(all.size(), 4u);
  for (uint32_t begin = 0; begin <= snapshot.text().size(); ++begin) {
    for (const uint32_t size : {0u, 1u, 60u}) {
      std::vector<CodeAction> expected = all;
      std::erase_if(expected, [&](const CodeAction& action) {
        return action.diagnostic.span.begin > begin + size || action.diagnostic.span.end < begin;
      });
      const uint32_t end = std::min(begin + size, snapshot.text().size());
      ASSERT_EQ(titles(code_actions(snapshot, {begin, end})), titles(expected)) << begin << " " << size;
    }
  }
}

}  // namespace
}  // namespace texbrdf::features
