#include <cmath>
#include <numbers>

#include "plots/preview_plot.h"
#include "plots/samples.h"
#include "unit/preview/exact.h"

namespace texbrdf::plots {
namespace {

constexpr std::size_t kMiddle = 180;

using preview::ExactModel;
using preview::model_of;
using preview::model_of_equations;
using preview::model_of_loop;

Curve plot(const ExactModel& model, const render::SphereView& view) {
  return sample_curve(model, request_beside(view, View::ThetaO), quick_effort(View::ThetaO));
}

double cosine(double degrees) {
  return std::cos(degrees * std::numbers::pi / 180);
}

TEST(Plot, GoesFromOneHorizonToTheOtherByHalfDegrees) {
  const Curve flat = plot(model_of_equations("f = 0.5 / \\pi"), {.theta = 30, .times_cosine = false});
  EXPECT_EQ(flat.problem, "");
  ASSERT_EQ(flat.angles.size(), 361U);
  ASSERT_EQ(flat.values.size(), 361U);
  for (std::size_t i = 0; i < flat.angles.size(); ++i) {
    EXPECT_EQ(flat.angles[i], -90 + 0.5 * static_cast<double>(i));
    EXPECT_EQ((*flat.values[i])[0], 0.5 / std::numbers::pi);
  }
}

TEST(Plot, HasTheCosineOfTheViewerWhereThePictureHasOne) {
  const Curve plotted = plot(model_of_equations("f = \\vec{0.2, 0.4, 0.6} * 1"), {.theta = 30});
  for (std::size_t i = 0; i < plotted.angles.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR((*plotted.values[i])[c], 0.2 * static_cast<double>(c + 1) * cosine(plotted.angles[i]), 1e-12);
    }
  }
  EXPECT_EQ((*plotted.values.front())[0], 0);
  EXPECT_EQ((*plotted.values.back())[0], 0);
}

TEST(Plot, PositiveAnglesAreAwayFromTheLight) {
  const ExactModel angle_between = model_of_equations("f = \\vec{\\omega_i} \\cdot \\vec{\\omega_o}");
  const ExactModel mirrored = model_of_equations(
      "f = (2 * (\\vec{n} \\cdot \\vec{\\omega_i}) * \\vec{n} - \\vec{\\omega_i}) \\cdot \\vec{\\omega_o}");
  for (const render::SphereView& view : {render::SphereView{.theta = 40, .phi = 0, .times_cosine = false},
                                         render::SphereView{.theta = 40, .phi = 200, .times_cosine = false},
                                         render::SphereView{.theta = -40, .phi = 77, .times_cosine = false},
                                         render::SphereView{.theta = 320, .phi = -30, .times_cosine = false}}) {
    const Curve towards = plot(angle_between, view);
    const Curve away = plot(mirrored, view);
    for (std::size_t i = 0; i < towards.angles.size(); ++i) {
      EXPECT_NEAR((*towards.values[i])[0], cosine(towards.angles[i] + 40), 1e-12) << view.phi;
      EXPECT_NEAR((*away.values[i])[0], cosine(away.angles[i] - 40), 1e-12) << view.phi;
    }
  }
}

TEST(Plot, ThePlaneStandsWhereTheLightIs) {
  const Curve along_y = plot(model_of_equations("f = \\phi_o"), {.theta = 0, .phi = 90, .times_cosine = false});
  EXPECT_NEAR((*along_y.values.front())[0], std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR((*along_y.values.back())[0], -std::numbers::pi / 2, 1e-12);
}

TEST(Plot, OnTheHorizonTheCosineIsExactlyZero) {
  const Curve grazing =
      plot(model_of_equations("f = 1 / (\\vec{n} \\cdot \\vec{\\omega_o})"), {.theta = 30, .times_cosine = false});
  EXPECT_TRUE(std::isinf((*grazing.values.front())[0]));
  EXPECT_TRUE(std::isinf((*grazing.values.back())[0]));
  EXPECT_EQ((*grazing.values[kMiddle])[0], 1);
}

TEST(Plot, TheLightIsWhereItIsForTheSphere) {
  for (const render::SphereView& view :
       {render::SphereView{.theta = 40, .phi = 200}, render::SphereView{.theta = -40, .phi = 77},
        render::SphereView{.theta = 320, .phi = -30}, render::SphereView{.theta = 720.5, .phi = 5}}) {
    const eval::Triple expected = render::light_direction(view);
    const eval::Triple light = geometry_in_plane(request_beside(view, View::Polar), 0).light;
    for (std::size_t i = 0; i < light.size(); ++i) EXPECT_NEAR(light[i], expected[i], 1e-12) << view.theta;
  }
}

TEST(Plot, ALightFromBehindIsTold) {
  for (const double theta : {90.0 + 1e-9, 120.0, 180.0, -170.0}) {
    for (const View view : {View::Polar, View::ThetaO, View::Lobe}) {
      EXPECT_EQ(problem_of(request_beside({.theta = theta}, view)), "the light is behind the surface");
    }
    EXPECT_EQ(problem_of(request_beside({.theta = theta}, View::ThetaH)), std::nullopt);
  }
  EXPECT_EQ(problem_of(request_beside({.theta = 89.9}, View::Polar)), std::nullopt);
}

TEST(Plot, ASlowBrdfHasFewerSamples) {
  const Curve coarse = plot(model_of_loop(10'000), {.theta = 30, .times_cosine = false});
  EXPECT_EQ(coarse.problem, "");
  ASSERT_GT(coarse.angles.size(), 3U);
  EXPECT_LT(coarse.angles.size(), 50U);
  EXPECT_EQ(coarse.angles.front(), -90);
  EXPECT_EQ(coarse.angles[coarse.angles.size() / 2], 0);
  EXPECT_EQ(coarse.angles.back(), 90);
  for (const Sample& value : coarse.values) EXPECT_EQ((*value)[0], 10'000);
}

TEST(Plot, ABrdfThatIsTooSlowHasNone) {
  std::string loops =
      "%0: ℝ = constant 1\n%1: ℝ = constant 60000\n%j: ℝ = bound k1\n%k: ℝ = bound k0\n%b: ℝ = multiply %k %j\n"
      "%s: ℝ = sum k0 %0 %1 %b\n%t: ℝ = sum k1 %0 %1 %s\nroots %t";
  const Curve none = plot(model_of(test::program_of_graph(test::read_graph(loops), 0)), {});
  EXPECT_TRUE(none.values.empty());
  EXPECT_EQ(none.problem, "the BRDF is too slow to be plotted");
}

}  // namespace
}  // namespace texbrdf::plots
