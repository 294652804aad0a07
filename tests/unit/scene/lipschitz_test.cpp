#include "scene/lipschitz.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>
#include <random>

#include "scene/primitives.h"

namespace texbrdf::scene {
namespace {

NodeId add(Scene& scene, ObjectKind kind, const std::vector<double>& data, std::vector<NodeId> children = {}) {
  Node node;
  node.kind = kind;
  node.data = with_defaults(object_entry(kind), data);
  node.children = std::move(children);
  scene.nodes.push_back(node);
  return NodeId{static_cast<uint32_t>(scene.nodes.size() - 1)};
}

TEST(Lipschitz, OfEachNode) {
  Scene scene;
  const NodeId ball = add(scene, ObjectKind::Cylinder, {0.5, 2});
  const NodeId twist = add(scene, ObjectKind::Twist, {3}, {ball});
  const NodeId waves = add(scene, ObjectKind::Displacement, {-0.1, 20}, {twist});
  const NodeId plane = add(scene, ObjectKind::Plane, {0, 1, 0, 0});
  const NodeId bend = add(scene, ObjectKind::Bend, {1}, {plane});
  scene.roots = {waves, bend};
  const std::vector<double> bounds = lipschitz_bounds(scene);
  EXPECT_EQ(bounds[ball.value], 1);
  EXPECT_NEAR(bounds[twist.value], twist_slope(3, 2 * std::sqrt(2.0)), 1e-12);  // to the corners of the box
  EXPECT_EQ(bounds[waves.value], 3);
  EXPECT_TRUE(std::isinf(bounds[bend.value]));
}

/// The largest slope that is found on a grid, against the formulas.
TEST(Lipschitz, TheSlopesAreReachedAndNotExceeded) {
  constexpr double kStep = 1e-6;
  double waves = 0;
  double twist = 0;
  double bend = 0;
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  const auto vector = [&] { return glm::dvec3(coordinate(generator), coordinate(generator), coordinate(generator)); };
  for (int i = 0; i < 200'000; ++i) {
    glm::dvec3 p = vector();
    const glm::dvec3 step = glm::normalize(vector()) * kStep;
    waves = std::max(waves, std::abs(displacement(p + step, 1, 7) - displacement(p, 1, 7)) / kStep);
    const double radius = std::hypot(p.x, p.z);
    p.x /= radius;  // to a radius of 1
    p.z /= radius;
    const auto twisted = [](const glm::dvec3& q) {
      const glm::dvec2 t = turned({q.z, q.x}, -2 * q.y);
      return glm::dvec3(t.y, q.y, t.x);
    };
    twist = std::max(twist, glm::distance(twisted(p + step), twisted(p)) / kStep);
    const auto bent = [](const glm::dvec2& q) { return turned(q, -2 * q.x); };
    const glm::dvec2 b = glm::normalize(glm::dvec2(vector()));
    const glm::dvec2 flat = glm::normalize(glm::dvec2(step)) * kStep;
    bend = std::max(bend, glm::distance(bent(b + flat), bent(b)) / kStep);
  }
  EXPECT_LE(waves, displacement_slope(1, 7) - 1 + 1e-4);
  EXPECT_GE(waves, 0.97 * (displacement_slope(1, 7) - 1));
  EXPECT_LE(twist, twist_slope(2, 1) + 1e-4);
  EXPECT_GE(twist, 0.99 * twist_slope(2, 1));
  EXPECT_LE(bend, bend_slope(2, 1) + 1e-4);
  EXPECT_GE(bend, 0.99 * bend_slope(2, 1));
}

}  // namespace
}  // namespace texbrdf::scene
