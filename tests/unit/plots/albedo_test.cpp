#include "plots/albedo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "unit/preview/exact.h"

namespace texbrdf::plots {
namespace {

using preview::model_of_equations;

Curve albedo_of(const preview::ExactModel& model, bool times_cosine = false, uint64_t steps = 200'000'000) {
  return sample_albedo(model, {.view = View::Albedo, .times_cosine = times_cosine}, {.steps = steps});
}

TEST(Albedo, OfAConstantIsTheConstantTimesPi) {
  const Curve curve = albedo_of(model_of_equations("f = \\vec{0.2, 0.4, 0.6} * 1 / \\pi"));
  ASSERT_EQ(curve.angles.size(), 90U);
  EXPECT_EQ(curve.angles.front(), 0);
  EXPECT_EQ(curve.angles.back(), 89);
  for (std::size_t i = 0; i < curve.angles.size(); ++i) {
    EXPECT_NEAR((*curve.values[i])[0], 0.2, 1e-14);
    EXPECT_NEAR((*curve.values[i])[1], 0.4, 1e-14);
    EXPECT_NEAR((*curve.values[i])[2], 0.6, 1e-14);
    EXPECT_LT(curve.errors[i][2], 1e-15);
  }
}

/// The integral of cos^n theta_o · cos theta_o is 2π / (n + 2).
TEST(Albedo, OfAPowerOfTheCosineIsKnown) {
  for (const int power : {1, 5, 50, 2000}) {
    const Curve curve =
        albedo_of(model_of_equations("f = (\\vec{n} \\cdot \\vec{\\omega_o})^{" + std::to_string(power) + "}"));
    for (std::size_t i = 0; i < curve.angles.size(); ++i) {
      const double expected = 2 * std::numbers::pi / (power + 2);
      EXPECT_NEAR((*curve.values[i])[0], expected, 2e-6 * expected) << power << " at " << curve.angles[i];
      EXPECT_LE(std::abs((*curve.values[i])[0] - expected), curve.errors[i][0] + 1e-14)
          << power << " at " << curve.angles[i];
    }
  }
}

/// Phong's lobe about the mirrored light: for light along the normal that is cos^n theta_o again.
TEST(Albedo, FindsANarrowLobeWhereverTheLightIs) {
  const Curve curve = albedo_of(model_of_equations(
      "f = \\max(0, (2 * (\\vec{n} \\cdot \\vec{\\omega_i}) * \\vec{n} - \\vec{\\omega_i}) \\cdot \\vec{\\omega_o})^{100000} / (\\vec{n} \\cdot \\vec{\\omega_o})"));
  for (std::size_t i = 0; i < curve.angles.size() && curve.angles[i] <= 85; ++i) {
    // Without the cosine the whole lobe is 2π / (n + 1).
    EXPECT_NEAR((*curve.values[i])[0] * 100'001 / (2 * std::numbers::pi), 1, 1e-5) << curve.angles[i];
  }
}

/// f = cos theta_i / cos theta_o has an integrable pole at the horizon: 2π cos theta_i.
TEST(Albedo, ComesToGripsWithAPoleAtTheHorizon) {
  const Curve curve = albedo_of(
      model_of_equations("f = (\\vec{n} \\cdot \\vec{\\omega_i}) / (\\vec{n} \\cdot \\vec{\\omega_o})"), true);
  for (std::size_t i = 0; i < curve.angles.size(); ++i) {
    const double cosine = std::cos(curve.angles[i] * std::numbers::pi / 180);
    const double expected = 2 * std::numbers::pi * cosine * cosine;
    EXPECT_NEAR((*curve.values[i])[0], expected, 1e-5 * expected) << curve.angles[i];
  }
}

TEST(Albedo, FewStepsGiveACoarseCurveWhoseErrorTellsSo) {
  const preview::ExactModel model = model_of_equations("f = (\\vec{n} \\cdot \\vec{\\omega_o})^{50}");
  const Curve coarse = albedo_of(model, false, 20'000);
  ASSERT_EQ(coarse.problem, "");
  ASSERT_GT(coarse.angles.size(), 1U);
  EXPECT_LT(coarse.angles.size(), 50U);
  for (std::size_t i = 0; i < coarse.angles.size(); ++i) {
    EXPECT_LE(std::abs((*coarse.values[i])[0] - 2 * std::numbers::pi / 52), coarse.errors[i][0]) << coarse.angles[i];
    EXPECT_GT(coarse.errors[i][0], 1e-9);
  }
}

TEST(Albedo, WhereNoNumberIsFoundThereIsNone) {
  const Curve curve = albedo_of(model_of_equations("f = \\sqrt{-1 * (\\vec{n} \\cdot \\vec{\\omega_o})}"));
  for (const Sample& value : curve.values) EXPECT_TRUE(std::isnan((*value)[0]));
}

TEST(Albedo, ABrdfThatIsTooSlowHasNone) {
  const Curve none = albedo_of(preview::model_of_loop(10'000), false, 100'000);
  EXPECT_TRUE(none.values.empty());
  EXPECT_EQ(none.problem, kTooSlow);
}

}  // namespace
}  // namespace texbrdf::plots
