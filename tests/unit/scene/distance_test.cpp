#include "scene/distance.h"

#include <gtest/gtest.h>

namespace texbrdf::scene {
namespace {

NodeId add(Scene& scene, ObjectKind kind, std::vector<double> data, std::vector<NodeId> children = {}) {
  Node node;
  node.kind = kind;
  node.data = with_defaults(object_entry(kind), data);
  node.children = std::move(children);
  scene.nodes.push_back(node);
  return NodeId{static_cast<uint32_t>(scene.nodes.size() - 1)};
}

TEST(Distances, SubtractionTakesAllOthersFromTheFirst) {
  Scene scene;
  const NodeId ball = add(scene, ObjectKind::Sphere, {1});
  const NodeId hole = add(scene, ObjectKind::Sphere, {0.5});
  scene.roots.push_back(add(scene, ObjectKind::Subtraction, {}, {ball, hole}));
  const Distances distances(scene);
  EXPECT_DOUBLE_EQ(distances.at({0, 0, 0}), 0.5);
  EXPECT_DOUBLE_EQ(distances.at({2, 0, 0}), 1);
  EXPECT_DOUBLE_EQ(distances.at({0.75, 0, 0}), -0.25);
}

TEST(Distances, LimitedRepetitionEndsWithCopyL) {
  Scene scene;
  const NodeId ball = add(scene, ObjectKind::Sphere, {0.25});
  scene.roots.push_back(add(scene, ObjectKind::LimitedRepetition, {1, 2, 0, 4}, {ball}));
  const Distances distances(scene);
  EXPECT_DOUBLE_EQ(distances.at({2, 0, 4}), -0.25);
  EXPECT_DOUBLE_EQ(distances.at({3, 0, 0}), 0.75);
  EXPECT_DOUBLE_EQ(distances.at({0, 1, 0}), 0.75);
}

TEST(Distances, AChildStandsInItsParentsFrame) {
  Scene scene;
  const NodeId ball = add(scene, ObjectKind::Sphere, {0.5});
  scene.nodes[ball.value].transform.position = {1, 0, 0};
  const NodeId parent = add(scene, ObjectKind::Union, {}, {ball});
  scene.nodes[parent.value].transform.scale = {2, 2, 2};
  scene.roots.push_back(parent);
  EXPECT_DOUBLE_EQ(Distances(scene).at({2, 0, 3}), 2);
}

}  // namespace
}  // namespace texbrdf::scene
