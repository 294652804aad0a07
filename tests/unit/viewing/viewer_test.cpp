#include "viewing/viewer.h"

#include <gtest/gtest.h>

#include <limits>

namespace texbrdf::viewing {
namespace {

using scene::Transform;
using scene::Triple;

scene::Node ball(std::string name, std::vector<scene::KeyBinding> keys) {
  scene::Node node;
  node.kind = scene::ObjectKind::Sphere;
  node.dynamic = scene::Dynamic{std::move(name), std::move(keys)};
  return node;
}

/// One ball moves with J, with W and with 2.
scene::Scene steered() {
  scene::Scene scene;
  scene.nodes = {ball("ball", {{"J", {1, 0, 0}, {}}, {"W", {0, 0, -1}, {}}, {"2", {0, 1, 0}, {}}})};
  scene.roots = {scene::NodeId{0}};
  return scene;
}

Input holding(HeldKeys held, double seconds = 0.125) {
  Input input;
  input.held = std::move(held);
  input.seconds = seconds;
  return input;
}

Input pressing(const std::string& key) {
  Input input = holding({key}, 0);
  input.pressed = {key};
  return input;
}

Triple ball_of(const Viewer& viewer) {
  return viewer.scene().nodes[0].transform.position;
}

TEST(Viewer, NothingLeavesThePictureAsItIs) {
  Viewer viewer(steered());
  EXPECT_FALSE(viewer.apply({}));
  EXPECT_FALSE(viewer.apply(holding({"X"})));
  EXPECT_EQ(viewer.view(), 0U);
}

TEST(Viewer, DragsTurnTheSceneWithThePointer) {
  Viewer viewer(steered());
  const scene::Camera before = viewer.scene().camera;
  Input input;
  input.drag_right = 0.1;
  EXPECT_TRUE(viewer.apply(input));
  // Seen from above the camera goes clockwise.
  const scene::Camera& after = viewer.scene().camera;
  EXPECT_LT(before.position[2] * after.position[0] - before.position[0] * after.position[2], 0);
  input = {};
  input.drag_down = 0.1;
  EXPECT_TRUE(viewer.apply(input));
  EXPECT_GT(viewer.scene().camera.position[1], before.position[1]);
}

TEST(Viewer, TheWheelComesNearer) {
  Viewer viewer(steered());
  Input input;
  input.wheel = 1;
  EXPECT_TRUE(viewer.apply(input));
  EXPECT_DOUBLE_EQ(viewer.scene().camera.position[0], 0.9 * scene::Camera().position[0]);
}

TEST(Viewer, KeysOfTheSceneMoveItsObjectsAndNotTheCamera) {
  Viewer viewer(steered());
  EXPECT_TRUE(viewer.apply(holding({"J", "W"})));
  EXPECT_EQ(ball_of(viewer), Triple({0.125, 0, -0.125}));
  EXPECT_EQ(viewer.scene().camera.position, scene::Camera().position);
  EXPECT_FALSE(viewer.apply(pressing("2")));
  EXPECT_EQ(viewer.view(), 0U);
}

TEST(Viewer, WithShiftAllKeysAreTheWindows) {
  Viewer viewer(steered());
  EXPECT_TRUE(viewer.apply(holding({"LEFT_SHIFT", "J", "W"})));
  EXPECT_EQ(ball_of(viewer), Triple({0, 0, 0}));
  EXPECT_NE(viewer.scene().camera.position, scene::Camera().position);
  Input input = pressing("2");
  input.held.insert("RIGHT_SHIFT");
  EXPECT_TRUE(viewer.apply(input));
  EXPECT_EQ(viewer.view(), 1U);
}

TEST(Viewer, ArrowsWalkLikeLettersAndTogetherNoFaster) {
  for (const auto& [letter, arrow] : {std::pair{"A", "LEFT"}, std::pair{"S", "DOWN"}, std::pair{"D", "RIGHT"}}) {
    Viewer one(steered());
    Viewer other(steered());
    Viewer both(steered());
    EXPECT_TRUE(one.apply(holding({letter})));
    EXPECT_TRUE(other.apply(holding({arrow})));
    EXPECT_TRUE(both.apply(holding({letter, arrow})));
    EXPECT_EQ(one.scene().camera.position, other.scene().camera.position) << letter;
    EXPECT_EQ(one.scene().camera.position, both.scene().camera.position) << letter;
    EXPECT_NE(one.scene().camera.position, scene::Camera().position) << letter;
  }
}

TEST(Viewer, DigitsSwitchTheView) {
  Viewer viewer(steered());
  for (const auto& [key, view] : {std::pair{"3", 2U}, std::pair{"KP_5", 4U}, std::pair{"1", 0U}}) {
    EXPECT_TRUE(viewer.apply(pressing(key)));
    EXPECT_EQ(viewer.view(), view);
    EXPECT_FALSE(viewer.apply(pressing(key)));
  }
  for (const char* none : {"6", "0", "KP_0", "KP_6", "F1"}) EXPECT_FALSE(viewer.apply(pressing(none))) << none;
}

TEST(Viewer, RPutsCameraAndObjectsBackAndKeepsTheView) {
  Viewer viewer(steered());
  viewer.apply(pressing("3"));
  viewer.apply(holding({"J", "S"}));
  EXPECT_TRUE(viewer.apply(pressing("R")));
  EXPECT_EQ(ball_of(viewer), Triple({0, 0, 0}));
  EXPECT_EQ(viewer.scene().camera.position, scene::Camera().position);
  EXPECT_EQ(viewer.view(), 2U);
  EXPECT_FALSE(viewer.apply(pressing("R")));
}

TEST(Viewer, EscapeClosesWhateverTheSceneBinds) {
  scene::Scene scene = steered();
  scene.nodes[0].dynamic->keys[0].key = "ESCAPE";
  Viewer viewer(scene);
  EXPECT_FALSE(viewer.wants_to_close());
  viewer.apply(pressing("ESCAPE"));
  EXPECT_TRUE(viewer.wants_to_close());
}

TEST(Viewer, ALongPauseMovesLittle) {
  Viewer viewer(steered());
  viewer.apply(holding({"J"}, 60));
  EXPECT_LE(ball_of(viewer)[0], 0.25);
  viewer.apply(holding({"J"}, -60));
  viewer.apply(holding({"J"}, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(ball_of(viewer)[0], 0.25);
}

TEST(Viewer, AReloadKeepsWhatTheFilesDoNotMove) {
  Viewer viewer(steered());
  viewer.apply(holding({"J", "S"}));
  const scene::Camera camera = viewer.scene().camera;
  scene::Scene changed = steered();
  changed.nodes.insert(changed.nodes.begin(), ball("another", {}));
  changed.environment.ambient = {1, 1, 1};
  viewer.reload(changed);
  EXPECT_EQ(viewer.scene().environment.ambient, Triple({1, 1, 1}));
  EXPECT_EQ(viewer.scene().camera.position, camera.position);
  EXPECT_EQ(viewer.scene().nodes[1].transform.position, Triple({0.125, 0, 0}));

  changed.nodes[1].transform.position = {0, 9, 0};
  changed.camera.position = {0, 0, 8};
  viewer.reload(changed);
  EXPECT_EQ(viewer.scene().camera.position, Triple({0, 0, 8}));
  EXPECT_EQ(viewer.scene().nodes[1].transform.position, Triple({0, 9, 0}));
  EXPECT_FALSE(viewer.apply(pressing("R")));
}

}  // namespace
}  // namespace texbrdf::viewing
