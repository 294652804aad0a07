#include "preview/plot.h"

#include <cmath>
#include <numbers>

#include "exact.h"

namespace texbrdf::preview {
namespace {

constexpr std::size_t kMiddle = 180;

double cosine(double degrees) {
  return std::cos(degrees * std::numbers::pi / 180);
}

TEST(Plot, GoesFromOneHorizonToTheOtherByHalfDegrees) {
  const Plot flat = plot(model_of_equations("f = 0.5 / \\pi"), {.theta = 30, .times_cosine = false});
  EXPECT_NEAR(flat.light_theta, 30, 1e-12);
  EXPECT_EQ(flat.problem, "");
  ASSERT_EQ(flat.angles.size(), 361U);
  ASSERT_EQ(flat.values.size(), 361U);
  for (std::size_t i = 0; i < flat.angles.size(); ++i) {
    EXPECT_EQ(flat.angles[i], -90 + 0.5 * static_cast<double>(i));
    EXPECT_EQ(flat.values[i][0], 0.5 / std::numbers::pi);
  }
}

TEST(Plot, HasTheCosineOfTheViewerWhereThePictureHasOne) {
  const Plot plotted = plot(model_of_equations("f = \\vec{0.2, 0.4, 0.6} * 1"), {.theta = 30});
  for (std::size_t i = 0; i < plotted.angles.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(plotted.values[i][c], 0.2 * static_cast<double>(c + 1) * cosine(plotted.angles[i]), 1e-12);
    }
  }
  EXPECT_EQ(plotted.values.front()[0], 0);
  EXPECT_EQ(plotted.values.back()[0], 0);
}

TEST(Plot, PositiveAnglesAreAwayFromTheLight) {
  const ExactModel angle_between = model_of_equations("f = \\vec{\\omega_i} \\cdot \\vec{\\omega_o}");
  const ExactModel mirrored = model_of_equations(
      "f = (2 * (\\vec{n} \\cdot \\vec{\\omega_i}) * \\vec{n} - \\vec{\\omega_i}) \\cdot \\vec{\\omega_o}");
  for (const render::SphereView& view : {render::SphereView{.theta = 40, .phi = 0, .times_cosine = false},
                                         render::SphereView{.theta = 40, .phi = 200, .times_cosine = false},
                                         render::SphereView{.theta = -40, .phi = 77, .times_cosine = false},
                                         render::SphereView{.theta = 320, .phi = -30, .times_cosine = false}}) {
    const Plot towards = plot(angle_between, view);
    const Plot away = plot(mirrored, view);
    EXPECT_NEAR(towards.light_theta, 40, 1e-9);
    for (std::size_t i = 0; i < towards.angles.size(); ++i) {
      EXPECT_NEAR(towards.values[i][0], cosine(towards.angles[i] + 40), 1e-12) << view.phi;
      EXPECT_NEAR(away.values[i][0], cosine(away.angles[i] - 40), 1e-12) << view.phi;
    }
  }
}

TEST(Plot, ThePlaneStandsWhereTheLightIs) {
  const Plot along_y = plot(model_of_equations("f = \\phi_o"), {.theta = 0, .phi = 90, .times_cosine = false});
  EXPECT_NEAR(along_y.values.front()[0], std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(along_y.values.back()[0], -std::numbers::pi / 2, 1e-12);
}

TEST(Plot, OnTheHorizonTheCosineIsExactlyZero) {
  const Plot grazing =
      plot(model_of_equations("f = 1 / (\\vec{n} \\cdot \\vec{\\omega_o})"), {.theta = 30, .times_cosine = false});
  EXPECT_TRUE(std::isinf(grazing.values.front()[0]));
  EXPECT_TRUE(std::isinf(grazing.values.back()[0]));
  EXPECT_EQ(grazing.values[kMiddle][0], 1);
}

TEST(Plot, ALightFromBehindIsTold) {
  for (const double theta : {90.0 + 1e-9, 120.0, 180.0, -170.0}) {
    const Plot dark = plot(model_of_equations("f = 1 / \\pi"), {.theta = theta});
    EXPECT_TRUE(dark.values.empty());
    EXPECT_TRUE(dark.angles.empty());
    EXPECT_EQ(dark.problem, "the light is behind the surface");
  }
}

TEST(Plot, ASlowBrdfHasFewerSamples) {
  const Plot coarse = plot(model_of_loop(10'000), {.theta = 30, .times_cosine = false});
  EXPECT_EQ(coarse.problem, "");
  ASSERT_GT(coarse.angles.size(), 3U);
  EXPECT_LT(coarse.angles.size(), 50U);
  EXPECT_EQ(coarse.angles.front(), -90);
  EXPECT_EQ(coarse.angles[coarse.angles.size() / 2], 0);
  EXPECT_EQ(coarse.angles.back(), 90);
  for (const eval::Triple& value : coarse.values) EXPECT_EQ(value[0], 10'000);
}

TEST(Plot, ABrdfThatIsTooSlowHasNone) {
  std::string loops =
      "%0: ℝ = constant 1\n%1: ℝ = constant 60000\n%j: ℝ = bound k1\n%k: ℝ = bound k0\n%b: ℝ = multiply %k %j\n"
      "%s: ℝ = sum k0 %0 %1 %b\n%t: ℝ = sum k1 %0 %1 %s\nroots %t";
  const Plot none = plot(model_of(test::program_of_graph(test::read_graph(loops), 0)), {});
  EXPECT_TRUE(none.values.empty());
  EXPECT_EQ(none.problem, "the BRDF is too slow to be plotted");
}

}  // namespace
}  // namespace texbrdf::preview
