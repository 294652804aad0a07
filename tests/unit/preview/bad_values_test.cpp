#include "preview/bad_values.h"

#include <cmath>

#include "exact.h"
#include "preview/cpu_frame.h"
#include "preview/surface_probe.h"

namespace texbrdf::preview {
namespace {

using render::BadPixel;

constexpr render::SphereView kView{.size = 64};

/// What is blamed for the first bad pixel, and its kind.
struct Blame {
  std::string origin;
  BadPixel kind;
  friend bool operator==(const Blame&, const Blame&) = default;
  friend void PrintTo(const Blame& blame, std::ostream* out) {
    *out << blame.origin << " is " << render::bad_pixel_entry(blame.kind).words;
  }
};

template <typename... Equations>
Blame blame(const Equations&... texts) {
  const BadValues found = find_bad_values(model_of_equations(texts...), kView);
  EXPECT_TRUE(found.first);
  return found.first ? Blame{found.first->origin, found.first->kind} : Blame{};
}

TEST(BadValues, AreThoseOfThePicture) {
  const ir::Program program = program_of(equations("c = \\cos{\\theta_i} - 0.5", "f = c / \\cos{\\theta_i}"));
  const BadValues found = find_bad_values(model_of(program), kView);
  render::SphereCache cache;
  EXPECT_EQ(found.counts, draw_on_cpu(*cpu_model(program), kView, cache).bad_pixels);
  EXPECT_GT(found.counts[BadPixel::Negative], 0U);
  EXPECT_EQ(found.size, 64U);
  EXPECT_EQ(found.problem, "");
}

TEST(BadValues, TheFirstIsWhereItIsSaidToBe) {
  const ExactModel model = model_of_equations("f = \\sqrt{0.5 - \\cos{\\theta_o}}");
  const BadValues found = find_bad_values(model, kView);
  ASSERT_TRUE(found.first);
  const auto probe = probe_surface(kView, found.first->place);
  ASSERT_TRUE(probe);
  eval::StepBudget budget{1000};
  EXPECT_TRUE(std::isnan((*model.value(probe->geometry, budget))[0]));
  EXPECT_LT(probe->view.theta, 60);
  EXPECT_GT(probe->view.theta, 55) << "the first row that is bad is at the edge of what is";
}

TEST(BadValues, AGoodBrdfHasNone) {
  const BadValues found = find_bad_values(model_of_equations("f = 1 / \\pi"), kView);
  EXPECT_EQ(found.counts.total(), 0U);
  EXPECT_FALSE(found.first);
}

TEST(BadValues, ComeFromTheFirstDefinitionThatIsBad) {
  EXPECT_EQ(blame("a = 1 - 2", "b = \\ln{a}", "c = b * 2", "f = c + 1"), (Blame{"b", BadPixel::NotANumber}));
  EXPECT_EQ(blame("b = 1 / (\\theta_h - \\theta_h)", "c = b * 2", "f = c + 1"), (Blame{"b", BadPixel::Infinite}));
  EXPECT_EQ(blame("b = -\\cos{\\theta_i}", "c = b * 2", "f = c"), (Blame{"b", BadPixel::Negative}));
}

TEST(BadValues, OfAFunctionComeFromItsCaller) {
  EXPECT_EQ(blame("g(x) = \\ln{-x}", "h(x) = g(x) + 1", "c = h(2)", "f = c"), (Blame{"c", BadPixel::NotANumber}));
}

TEST(BadValues, AreFollowedThroughFunctions) {
  EXPECT_EQ(blame("b = \\ln{-1}", "g(x) = b * x", "h(x) = g(x)", "f = h(2)"), (Blame{"b", BadPixel::NotANumber}));
}

TEST(BadValues, ANumberThatIsNoneMayComeFromAnInfiniteOne) {
  EXPECT_EQ(blame("b = 1 / (\\theta_h - \\theta_h)", "f = b - b"), (Blame{"b", BadPixel::NotANumber}));
  EXPECT_EQ(blame("b = 1 / (\\theta_h - \\theta_h)", "c = \\ln{-1}", "f = b + c"), (Blame{"c", BadPixel::NotANumber}));
}

TEST(BadValues, WhatDoesNoHarmIsNotBlamed) {
  EXPECT_EQ(blame("b = -\\cos{\\theta_i}", "c = b^2", "d = 0 - c", "f = c * d"), (Blame{"d", BadPixel::Negative}));
  EXPECT_EQ(blame("b = 1 / (\\theta_h - \\theta_h)", "c = \\exp{-b}", "f = c - 1"), (Blame{"f", BadPixel::Negative}));
}

TEST(BadValues, ADirectionIsNeverNegative) {
  EXPECT_EQ(blame("\\vec{d} = -\\vec{\\omega_o}", "f = \\vec{d} \\cdot \\vec{\\omega_o}"),
            (Blame{"f", BadPixel::Negative}));
}

TEST(BadValues, MayComeFromAParameter) {
  EXPECT_EQ(blame("k = -0.5", "g(x) = k * x", "f = g(\\cos{\\theta_i})"), (Blame{"k", BadPixel::Negative}));
}

TEST(BadValues, ThatOnlySinglePrecisionHasAreCountedAndNotExplained) {
  const BadValues found = find_bad_values(model_of_equations("f = 10^{30} * 10^{30} + \\theta_h"), kView);
  EXPECT_GT(found.counts[BadPixel::Infinite], 0U);
  EXPECT_FALSE(found.first);
}

TEST(BadValues, AreSearchedInASmallerPicture) {
  EXPECT_EQ(find_bad_values(model_of_equations("f = 1 / \\pi"), {.size = 2048}).size, 256U);
  const BadValues slow = find_bad_values(model_of_loop(5'000), {.size = 2048});
  EXPECT_LT(slow.size, 128U);
  EXPECT_GE(slow.size, 16U);
  const BadValues too_slow = find_bad_values(model_of_loop(65'000), {.size = 2048, .theta = 180});
  EXPECT_EQ(too_slow.size, 16U);
}

TEST(BadValues, ABrdfThatIsTooSlowIsNotSearched) {
  const std::string loops =
      "%0: ℝ = constant 1\n%1: ℝ = constant 60000\n%j: ℝ = bound k1\n%k: ℝ = bound k0\n%b: ℝ = multiply %k %j\n"
      "%s: ℝ = sum k0 %0 %1 %b\n%t: ℝ = sum k1 %0 %1 %s\nroots %t";
  const BadValues none = find_bad_values(model_of(test::program_of_graph(test::read_graph(loops), 0)), kView);
  EXPECT_EQ(none.size, 0U);
  EXPECT_EQ(none.problem, "the BRDF is too slow for a search of its bad pixels");
}

}  // namespace
}  // namespace texbrdf::preview
