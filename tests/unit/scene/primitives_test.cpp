#include "scene/primitives.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>
#include <random>

#include "scene/check.h"
#include "scene/frame.h"

namespace texbrdf::scene {
namespace {

bool is_primitive(const ObjectEntry& entry) {
  return entry.id != 0;
}

glm::dvec3 random_place(std::mt19937& generator) {
  std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
  return {coordinate(generator), coordinate(generator), coordinate(generator)};
}

double slope(ObjectKind kind, const glm::dvec3& place, const std::array<double, kMaxData>& data) {
  constexpr double kStep = 1e-6;
  glm::dvec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0);
    step[axis] = kStep;
    gradient[axis] =
        (primitive_distance(kind, place + step, data) - primitive_distance(kind, place - step, data)) / (2 * kStep);
  }
  return glm::length(gradient);
}

/// Edges of the medial axis, where the gradient jumps, are rare among random places.
TEST(Primitives, ExactOnesHaveASlopeOfOneAndBoundsNoMore) {
  for (const ObjectEntry& entry : object_entries()) {
    if (!is_primitive(entry)) continue;
    const auto data = with_defaults(entry, {});
    std::mt19937 generator(7);
    int wrong = 0;
    for (int i = 0; i < 2000; ++i) {
      const glm::dvec3 place = random_place(generator);
      const bool outside = primitive_distance(entry.kind, place, data) > 0;
      const bool exact = entry.exactness == Exactness::Exact || (entry.exactness == Exactness::ExactOutside && outside);
      const double length = slope(entry.kind, place, data);
      if (length > 1 + 1e-4 || (exact && length < 1 - 1e-4)) ++wrong;
    }
    EXPECT_LE(wrong, 4) << entry.name;
  }
}

/// No ball of the size of the distance reaches the other side of the surface.
TEST(Primitives, NoDistanceReachesThroughTheSurface) {
  for (const ObjectEntry& entry : object_entries()) {
    if (!is_primitive(entry)) continue;
    const auto data = with_defaults(entry, {});
    std::mt19937 generator(11);
    for (int i = 0; i < 2000; ++i) {
      const glm::dvec3 place = random_place(generator);
      const double distance = primitive_distance(entry.kind, place, data);
      const glm::dvec3 direction = glm::normalize(random_place(generator));
      const double there = primitive_distance(entry.kind, place + direction * std::abs(distance) * 0.999, data);
      EXPECT_GE(there * distance, -1e-12) << entry.name;
    }
  }
}

TEST(Primitives, TheShaderGetsWhatIsCalledAndWhatThatCalls) {
  const std::string text = functions_for("triangular_prism(p, 1.0, 1.0)");
  EXPECT_NE(text.find("real triangle_distance("), std::string::npos);
  EXPECT_NE(text.find("real length_above("), std::string::npos);
  EXPECT_EQ(text.find("real sphere("), std::string::npos);
}

TEST(Frames, ScaleThenRotationThenTranslation) {
  const double right_angle = std::acos(-1.0) / 2;
  const Frame frame = frame_of({{10, 0, 0}, {0, 0, right_angle}, {2, 3, 4}});
  const glm::dvec3 moved = frame.parent({1, 0, 0});  // scaled to 2 x, turned to 2 y
  EXPECT_NEAR(glm::distance(moved, glm::dvec3(10, 2, 0)), 0, 1e-12);
  EXPECT_NEAR(glm::distance(frame.local(moved), glm::dvec3(1, 0, 0)), 0, 1e-12);
  EXPECT_EQ(frame.factor, 2);
}

TEST(Frames, RotatesAboutXFirst) {
  const double right_angle = std::acos(-1.0) / 2;
  const glm::dvec3 turned_y = rotation_matrix({right_angle, 0, right_angle}) * glm::dvec3(0, 1, 0);
  EXPECT_NEAR(glm::distance(turned_y, glm::dvec3(0, 0, 1)), 0, 1e-12);
}

TEST(Check, TellsTheNumberThatIsWrong) {
  Scene scene;
  Node sphere;
  sphere.kind = ObjectKind::Sphere;
  sphere.data[0] = -1;
  scene.nodes.push_back(sphere);
  scene.roots.push_back(NodeId{0});
  const auto fault = find_fault(scene);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->message, "the radius must be more than 0, but is -1");
  EXPECT_EQ(fault->part, Part::NodeData);
  scene.nodes[0].data[0] = 1;
  EXPECT_FALSE(find_fault(scene));
}

TEST(Check, RefusesWhatIsNoTree) {
  Scene scene;
  Node node;
  node.children.push_back(NodeId{0});
  scene.nodes.push_back(node);
  scene.roots.push_back(NodeId{0});
  ASSERT_TRUE(find_fault(scene));
  EXPECT_EQ(find_fault(scene)->part, Part::NodeChildren);
}

}  // namespace
}  // namespace texbrdf::scene
