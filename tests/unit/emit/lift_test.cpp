#include "emit/lift.h"

#include <gtest/gtest.h>

#include "support/linkable_document.h"

namespace texbrdf::emit {
namespace {

std::string equation(const std::string& text) {
  return "\\begin{equation}\n" + text + "\n\\end{equation}\n";
}

/// The names of what the first function captures, in order.
std::vector<std::string> captures(const std::string& text, ParameterScope scope) {
  ir::Program program = *test::LinkableDocument(text).link();
  LiftedProgram lifted = *lift(program, scope);
  std::vector<std::string> result;
  for (const Capture& capture : lifted.functions.back().captures) {
    switch (capture.kind) {
      case Capture::Kind::Parameter:
        result.push_back(program.parameters[capture.index].canonical);
        break;
      case Capture::Kind::Definition:
        result.push_back(program.definitions[capture.index].canonical);
        break;
      case Capture::Kind::Input:
      case Capture::Kind::Derived:
        result.emplace_back(convention_entry(static_cast<Convention>(capture.index)).symbol);
        break;
    }
  }
  return result;
}

using Names = std::vector<std::string>;

const std::string kDocument = equation("m = 0.5") + equation("c = \\vec{n} \\cdot \\omega_i") +
                              equation("g(x) = x * m + c") +
                              equation("h(x) = g(x) + \\theta_h + \\vec{n} \\cdot \\omega_o") + equation("f = h(1)");

TEST(Lift, FunctionsGetWhatTheyAndTheirCalleesUse) {
  EXPECT_EQ(captures(kDocument, ParameterScope::EntryPoint), (Names{"V", "N", "m", "c", "theta_h"}));
  EXPECT_EQ(captures(kDocument, ParameterScope::Everywhere), (Names{"V", "N", "c", "theta_h"}));
}

TEST(Lift, FormalsAreNoCaptures) {
  EXPECT_EQ(
      captures(equation("m = 0.5") + equation("g(m) = m + \\pi") + equation("f = g(m)"), ParameterScope::EntryPoint),
      Names{});
}

TEST(Lift, AnotherWordForAnInputIsTheInput) {
  const std::string text = equation("N = \\vec{n}") + equation("g(x) = x * (N \\cdot N)") + equation("f = g(2)");
  ir::Program program = *test::LinkableDocument(text).link();
  LiftedProgram lifted = *lift(program, ParameterScope::EntryPoint);
  EXPECT_EQ(lifted.definitions.size(), 1u) << "only f";
  EXPECT_EQ(captures(text, ParameterScope::EntryPoint), Names{"N"});
}

TEST(Lift, AWordThatLooksLikeAnotherInputIsKept) {
  const std::string text = equation("V = \\vec{n}") + equation("f = V \\cdot V");
  ir::Program program = *test::LinkableDocument(text).link();
  EXPECT_EQ(lift(program, ParameterScope::EntryPoint)->definitions.size(), 2u);
}

TEST(Lift, FormalsOfTheRootAreTheDirections) {
  ir::Program program =
      *test::LinkableDocument(equation("f(\\vec{a}, \\vec{b}) = \\vec{a} \\cdot \\vec{b} + \\vec{n} \\cdot \\omega_i"))
           .link();
  program = with_directions_for_root_formals(std::move(program));
  for (const ir::Value& value : program.root().graph.values()) EXPECT_NE(value.op, ir::Op::Formal);
}

}  // namespace
}  // namespace texbrdf::emit
