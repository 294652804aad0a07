#include "preview/exact_model.h"

#include <cmath>
#include <numbers>

#include "eval/compile.h"
#include "exact.h"
#include "support/read_file.h"

namespace texbrdf::preview {
namespace {

constexpr eval::Geometry kOblique{.light = {0.6, 0, 0.8}, .view = {0, -0.28, 0.96}};

std::string names(const ir::Program& program) {
  std::string text;
  for (const Quantity& quantity : quantities(program)) {
    const char* const type = quantity.type == Type::Real ? "real" : quantity.type == Type::Colour ? "colour" : "vector";
    text += quantity.name + ":" + type + " ";
  }
  return text;
}

eval::Triple value_of(const ExactModel& model, std::string_view name) {
  eval::StepBudget budget{1000};
  const Quantity* const quantity = model.find(name);
  EXPECT_NE(quantity, nullptr) << name;
  return quantity == nullptr ? eval::Triple{} : model.value(*quantity, kOblique, budget).value_or(eval::Triple{});
}

TEST(Quantities, StandBehindWhatTheyNeed) {
  const ir::Program program = program_of(
      equations("a = 2", "b = 3", "u = b * \\cos{\\theta_i}", "w = 7", "\\rho = \\vec{0.1, 0.2, 0.3}", "h(x) = a * x",
                "\\vec{d} = 2 * \\vec{\\omega_i}", "f = \\rho * h(u) * (\\vec{d} \\cdot \\vec{n})"));
  EXPECT_EQ(names(program), "b:real u:real a:real \\vec{d}:vector \\rho:colour f:colour ");
}

TEST(Quantities, TheBrdfMayBeAFunctionOfTwoVectors) {
  const ir::Program program = program_of(equations("a = 2", "f(\\vec{x}, \\vec{y}) = a * (\\vec{x} \\cdot \\vec{y})"));
  EXPECT_EQ(names(program), "a:real f:real ");
  EXPECT_NEAR(value_of(model_of(program), "f")[0], 2 * 0.8 * 0.96, 1e-15);
}

TEST(ExactModel, HasTheValueOfEachQuantity) {
  const ExactModel model = model_of_equations("a = 2", "c = \\cos{\\theta_i}", "\\vec{d} = c * \\vec{\\omega_o}",
                                              "g(x) = x + a", "f = g(c) / \\pi");
  EXPECT_EQ(value_of(model, "a")[0], 2);
  EXPECT_NEAR(value_of(model, "c")[0], 0.8, 1e-15);
  EXPECT_EQ(model.find("\\vec{d}"), nullptr) << "f does not need it";
  EXPECT_EQ(model.find("g"), nullptr) << "a function has no value of its own";
  EXPECT_NEAR(value_of(model, "f")[0], 2.8 / std::numbers::pi, 1e-15);
  EXPECT_EQ(value_of(model, "f"), value_of(model, model.brdf().name));
}

TEST(ExactModel, GivesAllValuesInOrder) {
  const ExactModel model = model_of_equations("a = 2", "c = \\cos{\\theta_i}", "f = a * c");
  eval::StepBudget budget{1000};
  const auto values = model.values(kOblique, budget);
  ASSERT_TRUE(values);
  ASSERT_EQ(values->size(), model.quantities().size());
  for (std::size_t i = 0; i < values->size(); ++i) {
    EXPECT_EQ((*values)[i], value_of(model, model.quantities()[i].name)) << model.quantities()[i].name;
  }
}

TEST(ExactModel, ALambertianBrdfIsTheReflectanceOverPi) {
  const ExactModel model = model_of_equations("\\rho = \\vec{0.3, 0.6, 0.9}", "f = \\rho / \\pi");
  EXPECT_EQ(value_of(model, "f"),
            (eval::Triple{0.3 / std::numbers::pi, 0.6 / std::numbers::pi, 0.9 / std::numbers::pi}));
}

TEST(ExactModel, HasTheValueThatTexbrdfEvalHas) {
  for (const char* const name : {"ward", "cook-torrance", "edwards-2006", "conventions"}) {
    Document document(test::read_file(std::string(TEXBRDF_TEST_DATA) + "/models/" + name + ".tex"));
    const auto program = document.snapshot().program();
    ASSERT_TRUE(program);
    const auto compiled = eval::compile(*program);
    ASSERT_TRUE(compiled);
    const ExactModel model = model_of(*program);
    eval::StepBudget budget{10'000};
    EXPECT_EQ(model.value(kOblique, budget),
              eval::ReferenceEvaluator(compiled->unoptimised).evaluate(kOblique, compiled->parameters))
        << name;
  }
}

TEST(ExactModel, ASlowValueIsGivenUp) {
  const ExactModel model = model_of_loop(60'000);
  eval::StepBudget budget{10'000};
  EXPECT_EQ(model.value(kOblique, budget), std::nullopt);
  EXPECT_EQ(budget.left, 0U);
  budget.left = 10'000;
  EXPECT_EQ(model.values(kOblique, budget), std::nullopt);
}

TEST(ExactModel, EquationsThatGrowWithoutBoundAreTooLarge) {
  std::string document = equation("g_{0}(x) = \\sin{x} + x");
  for (int i = 1; i <= 40; ++i) {
    const std::string inner = "g_{" + std::to_string(i - 1) + "}";
    document += equation("g_{" + std::to_string(i) + "}(x) = " + inner + "(x + 1) * " + inner + "(x + 2)");
  }
  const auto model = ExactModel::compile(program_of(document + equation("f = g_{40}(\\theta_h)")));
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error(), "the equations are too large for values at a point");
}

}  // namespace
}  // namespace texbrdf::preview
