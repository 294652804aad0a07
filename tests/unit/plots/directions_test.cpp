#include "plots/directions.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace texbrdf::plots {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

double dot(const eval::Triple& a, const eval::Triple& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double length(const eval::Triple& v) {
  return std::sqrt(dot(v, v));
}

eval::Triple half_of(const eval::Geometry& geometry) {
  eval::Triple half{};
  for (std::size_t i = 0; i < half.size(); ++i) half[i] = geometry.light[i] + geometry.view[i];
  const double size = length(half);
  for (double& component : half) component /= size;
  return half;
}

/// The angle between the plane of normal and half vector and that of light and half vector, from their dihedral.
double phi_d_of(const eval::Geometry& geometry) {
  const eval::Triple half = half_of(geometry);
  const auto off_half = [&](const eval::Triple& v) {
    const double along = dot(v, half);
    return eval::Triple{v[0] - along * half[0], v[1] - along * half[1], v[2] - along * half[2]};
  };
  const eval::Triple away = off_half({0, 0, -1});  // where the half vector leans, seen along it
  const eval::Triple light = off_half(geometry.light);
  const eval::Triple across = {away[1] * light[2] - away[2] * light[1], away[2] * light[0] - away[0] * light[2],
                               away[0] * light[1] - away[1] * light[0]};
  return std::atan2(dot(across, half), dot(away, light)) * kDegrees;
}

TEST(Directions, SinesAreExactWhereTheyAreKnown) {
  for (const double turn : {-720.0, -360.0, 0.0, 360.0, 1080.0}) {
    EXPECT_EQ(sine_of(turn), 0);
    EXPECT_EQ(sine_of(turn + 90), 1);
    EXPECT_EQ(sine_of(turn + 180), 0);
    EXPECT_EQ(sine_of(turn - 90), -1);
    EXPECT_EQ(cosine_of(turn), 1);
    EXPECT_EQ(cosine_of(turn + 90), 0);
    EXPECT_EQ(cosine_of(turn + 180), -1);
    EXPECT_EQ(cosine_of(turn - 90), 0);
  }
  for (double degrees = -400; degrees < 400; degrees += 7.3) {
    EXPECT_NEAR(sine_of(degrees), std::sin(degrees / kDegrees), 1e-14);
    EXPECT_NEAR(cosine_of(degrees), std::cos(degrees / kDegrees), 1e-14);
  }
}

TEST(Directions, HalfAnglesAreThoseOfTheHalfVector) {
  for (const double theta_h : {3.0, 20.0, 45.0, 77.0}) {
    for (const double phi_h : {0.0, 33.0, -120.0}) {
      for (const double theta_d : {2.0, 30.0, 60.0, 88.0}) {
        for (const double phi_d : {90.0, -90.0, 25.0, 179.0, 0.0}) {
          const eval::Geometry geometry = geometry_of({theta_h, phi_h, theta_d, phi_d});
          const eval::Triple half = half_of(geometry);
          EXPECT_NEAR(length(geometry.light), 1, 1e-12);
          EXPECT_NEAR(length(geometry.view), 1, 1e-12);
          EXPECT_NEAR(std::acos(half[2]) * kDegrees, theta_h, 1e-9);
          EXPECT_NEAR(std::atan2(half[1], half[0]) * kDegrees, phi_h, 1e-9);
          EXPECT_NEAR(std::acos(dot(half, geometry.light)) * kDegrees, theta_d, 1e-9);
          EXPECT_NEAR(phi_d_of(geometry), phi_d, 1e-9);
        }
      }
    }
  }
}

TEST(Directions, AQuarterTurnAboutTheHalfVectorNeverLeavesTheHemisphere) {
  for (double theta_h = 0; theta_h <= 90; theta_h += 7.5) {
    for (double theta_d = 0; theta_d <= 90; theta_d += 7.5) {
      EXPECT_TRUE(is_above_horizon(geometry_of({theta_h, 15, theta_d, 90}))) << theta_h << " " << theta_d;
    }
  }
}

TEST(Directions, BelowTheHorizonIsWhereTheAnglesAddUpToMoreThanARightOne) {
  EXPECT_TRUE(is_above_horizon(geometry_of({40, 0, 49, 0})));
  EXPECT_TRUE(is_above_horizon(geometry_of({40, 0, 50, 0})));
  EXPECT_FALSE(is_above_horizon(geometry_of({40, 0, 51, 0})));
}

}  // namespace
}  // namespace texbrdf::plots
