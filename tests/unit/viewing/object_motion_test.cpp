#include "viewing/object_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene/frame.h"

namespace texbrdf::viewing {
namespace {

using scene::Dynamic;
using scene::Transform;
using scene::Triple;

constexpr double kPi = std::numbers::pi;

const Dynamic kBall{"ball", {{"J", {-1, 0, 0}, {}}, {"L", {2, 0, 0}, {}}, {"O", {}, {0, 1, 0}}, {"P", {}, {0, 0, 1}}}};

void expect_same_rotation(const Triple& one, const glm::dmat3& other) {
  const glm::dmat3 matrix = scene::rotation_matrix(one);
  for (int i = 0; i < 3; ++i) EXPECT_LT(glm::distance(matrix[i], other[i]), 1e-9) << "column " << i;
}

TEST(ObjectMotion, AKeyMovesByItsVelocity) {
  Transform from;
  from.position = {1, 2, 3};
  EXPECT_EQ(moved(from, kBall, {"J"}, 0.5).position, Triple({0.5, 2, 3}));
  EXPECT_EQ(moved(from, kBall, {}, 0.5), from);
  EXPECT_EQ(moved(from, kBall, {"X"}, 0.5), from);
}

TEST(ObjectMotion, KeysAddUp) {
  EXPECT_EQ(moved({}, kBall, {"J", "L"}, 1).position, Triple({1, 0, 0}));
}

TEST(ObjectMotion, TurningIsInTheFrameOfTheParent) {
  Transform from;
  from.rotation = {0.3, -0.4, 0.5};
  const Transform to = moved(from, kBall, {"P"}, 0.25);
  expect_same_rotation(to.rotation, scene::rotation_matrix({0, 0, 0.25}) * scene::rotation_matrix(from.rotation));
  EXPECT_EQ(to.position, from.position);
  EXPECT_EQ(to.scale, from.scale);
}

TEST(ObjectMotion, TurningGoesThroughARightAngle) {
  Transform transform;
  for (int i = 0; i < 8; ++i) {
    transform = moved(transform, kBall, {"O"}, kPi / 4);
    expect_same_rotation(transform.rotation, scene::rotation_matrix({0, (i + 1) * kPi / 4, 0}));
  }
  expect_same_rotation(transform.rotation, glm::dmat3(1));
}

TEST(ObjectMotion, ManySmallTurnsAreOneLargeOne) {
  Transform transform;
  transform.rotation = {0.1, 0.2, 0.3};
  for (int i = 0; i < 1000; ++i) transform = moved(transform, kBall, {"O"}, 0.002);
  expect_same_rotation(transform.rotation, scene::rotation_matrix({0, 2, 0}) * scene::rotation_matrix({0.1, 0.2, 0.3}));
}

TEST(ObjectMotion, NothingLeavesTheWorld) {
  const Dynamic fast{"fast", {{"J", {1e30, 0, 0}, {}}, {"K", {}, {1e300, 1e300, 0}}}};
  EXPECT_EQ(moved({}, fast, {"J"}, 1), Transform());
  const Transform turned = moved({}, fast, {"K"}, 1);
  for (const double angle : turned.rotation) EXPECT_TRUE(std::isfinite(angle));
}

TEST(ObjectMotion, OnlyDynamicObjectsMove) {
  scene::Scene scene;
  scene.nodes.resize(2);
  scene.nodes[1].dynamic = kBall;
  EXPECT_TRUE(move_objects(scene, {"L"}, 1));
  EXPECT_EQ(scene.nodes[0].transform, Transform());
  EXPECT_EQ(scene.nodes[1].transform.position, Triple({2, 0, 0}));
  EXPECT_FALSE(move_objects(scene, {"W"}, 1));
  EXPECT_TRUE(binds(scene, "O"));
  EXPECT_FALSE(binds(scene, "W"));
}

}  // namespace
}  // namespace texbrdf::viewing
