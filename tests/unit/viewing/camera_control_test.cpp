#include "viewing/camera_control.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "scene/frame.h"

namespace texbrdf::viewing {
namespace {

using scene::Camera;
using scene::to_vector;
using scene::Triple;

constexpr double kPi = std::numbers::pi;

Camera camera_at(const Triple& position, const Triple& target = {0, 0, 0}) {
  Camera camera;
  camera.position = position;
  camera.target = target;
  return camera;
}

void expect_near(const Triple& one, const Triple& other, double tolerance = 1e-12) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(one[i], other[i], tolerance) << "component " << i;
}

double distance_of(const Camera& camera) {
  return glm::distance(to_vector(camera.position), to_vector(camera.target));
}

TEST(CameraControl, AQuarterTurnToTheRightLooksFromTheRight) {
  const Camera camera = orbit(camera_at({1, 5, 4}, {1, 5, 2}), kPi / 2, 0);
  expect_near(camera.position, {3, 5, 2});
  expect_near(camera.target, {1, 5, 2});
  EXPECT_EQ(camera.up, Triple({0, 1, 0}));
}

TEST(CameraControl, RaisingLooksFromAbove) {
  const double half = std::sqrt(0.5);
  expect_near(orbit(camera_at({0, 0, 2}), 0, kPi / 4).position, {0, 2 * half, 2 * half});
  expect_near(orbit(camera_at({0, 0, 2}), 0, -kPi / 4).position, {0, -2 * half, 2 * half});
}

TEST(CameraControl, OrbitsStopShortOfThePolesAndKeepTheDistance) {
  for (const double above : {10.0, -10.0}) {
    const Camera top = orbit(camera_at({0.3, 0.2, 2}), 0, above);
    EXPECT_NEAR(distance_of(top), distance_of(camera_at({0.3, 0.2, 2})), 1e-12);
    const Camera again = orbit(top, 0, above);
    expect_near(again.position, top.position);
    EXPECT_GT(std::hypot(top.position[0], top.position[2]), 0.01);
    EXPECT_GT(top.position[1] * above, 0);
  }
}

TEST(CameraControl, ACircleLeadsBack) {
  Camera camera = camera_at({2, 1.5, 3}, {0.5, 0, 0});
  for (int i = 0; i < 100; ++i) camera = orbit(camera, kPi / 50, 0);
  expect_near(camera.position, {2, 1.5, 3}, 1e-9);
}

TEST(CameraControl, UpNeedNotBeY) {
  Camera camera = camera_at({2, 0, 0});
  camera.up = {0, 0, 7};
  expect_near(orbit(camera, kPi / 2, 0).position, {0, 2, 0});
}

TEST(CameraControl, ACameraThatLooksAlongUpCanBeTurnedAwayFromIt) {
  const Camera camera = orbit(camera_at({0, 3, 0}), 0, -kPi / 4);
  EXPECT_NEAR(camera.position[1], 3 * std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(distance_of(camera), 3, 1e-9);
}

TEST(CameraControl, NotchesComeNearerByATenthAndLeadBack) {
  const Camera near = dolly(camera_at({0, 0, 2}), 1);
  expect_near(near.position, {0, 0, 1.8});
  expect_near(dolly(near, -1).position, {0, 0, 2});
}

TEST(CameraControl, NoNotchesReachTheTargetOrLeaveTheWorld) {
  EXPECT_GT(distance_of(dolly(camera_at({0, 0, 2}), 1e6)), 0);
  EXPECT_LE(distance_of(dolly(camera_at({0, 0, 2}), -1e6)), 1e5);
}

TEST(CameraControl, WalkingTakesTheTargetAlong) {
  const Camera camera = walk(camera_at({0, 0, 2}), {.right = 1, .up = -1, .forward = 0.5}, 0.25);
  expect_near(camera.position, {0.5, -0.5, 1.75});
  expect_near(camera.target, {0.5, -0.5, -0.25});
}

TEST(CameraControl, WhatIsNotFiniteMovesNothing) {
  const Camera camera = camera_at({0, 0, 2});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(orbit(camera, nan, 0).position, camera.position);
  EXPECT_EQ(dolly(camera, nan).position, camera.position);
  EXPECT_EQ(walk(camera, {.forward = 1}, std::numeric_limits<double>::infinity()).position, camera.position);
}

}  // namespace
}  // namespace texbrdf::viewing
