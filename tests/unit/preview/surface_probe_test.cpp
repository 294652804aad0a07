#include "preview/surface_probe.h"

#include <gtest/gtest.h>

#include <cmath>

namespace texbrdf::preview {
namespace {

constexpr double kRadius = 0.45;

/// The place where the normal leans so far to the right and upwards.
render::PicturePlace place_of(double x, double y) {
  return {0.5 + kRadius * x, 0.5 - kRadius * y};
}

void expect_angles(const Angles& actual, double theta, double phi) {
  EXPECT_NEAR(actual.theta, theta, 1e-9);
  EXPECT_NEAR(actual.phi, phi, 1e-9);
}

TEST(SurfaceProbe, TheMiddleHasTheAnglesOfTheView) {
  const auto probe = probe_surface({.theta = 40, .phi = 110}, {0.5, 0.5});
  ASSERT_TRUE(probe);
  expect_angles(probe->light, 40, 110);
  EXPECT_NEAR(probe->view.theta, 0, 1e-9);
  EXPECT_TRUE(probe->is_lit);
}

TEST(SurfaceProbe, AnglesAreThoseOfTheTangentFrame) {
  // N = (1/2, 0, √3/2), so X = (√3/2, 0, -1/2) and Y = (0, 1, 0).
  const auto right = probe_surface({.theta = 90, .phi = 90}, place_of(0.5, 0));
  ASSERT_TRUE(right);
  expect_angles(right->view, 30, 180);
  expect_angles(right->light, 90, 90);
  // N = (0, 1/2, √3/2), so X = (1, 0, 0) and Y = (0, √3/2, -1/2).
  const auto up = probe_surface({.theta = 90, .phi = 90}, place_of(0, 0.5));
  ASSERT_TRUE(up);
  expect_angles(up->view, 30, -90);
  expect_angles(up->light, 60, 90);
  EXPECT_TRUE(up->is_lit);
}

TEST(SurfaceProbe, ASideIsDark) {
  const render::SphereView from_the_left{.theta = 90, .phi = 180};
  EXPECT_TRUE(probe_surface(from_the_left, place_of(-0.5, 0))->is_lit);
  const auto dark = probe_surface(from_the_left, place_of(0.5, 0));
  ASSERT_TRUE(dark);
  EXPECT_FALSE(dark->is_lit);
  EXPECT_NEAR(dark->light.theta, 120, 1e-9);
}

TEST(SurfaceProbe, ZoomMovesThePoints) {
  const auto probe = probe_surface({.theta = 0, .zoom = 2}, {0.5 + 2 * kRadius * 0.5, 0.5});
  ASSERT_TRUE(probe);
  expect_angles(probe->view, 30, 180);
  EXPECT_FALSE(probe_surface({.zoom = 0.5}, place_of(0.5, 0.1)));
}

TEST(SurfaceProbe, GeometryIsAFrameOfThePicture) {
  const auto probe = probe_surface({.theta = 30, .phi = 0}, place_of(0.6, 0));
  ASSERT_TRUE(probe);
  EXPECT_NEAR(probe->geometry.light[0], 0.5, 1e-15);
  EXPECT_EQ(probe->geometry.view, (eval::Triple{0, 0, 1}));
  EXPECT_NEAR(probe->geometry.normal[0], 0.6, 1e-15);
  EXPECT_NEAR(probe->geometry.tangent[2], -0.6, 1e-15);
}

}  // namespace
}  // namespace texbrdf::preview
