#include "render/scene_view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "render/scene_text.h"
#include "render/shader_complaint.h"

namespace texbrdf::render {
namespace {

TEST(SceneView, SamplesLieInTheirPixelAndFillIt) {
  std::array<int, 16> cells{};
  for (uint32_t i = 0; i < 256; ++i) {
    const SceneSample sample = scene_sample(i);
    for (const float value : {sample.pixel[0], sample.pixel[1], sample.ambient[0], sample.ambient[1]}) {
      ASSERT_GE(value, 0);
      ASSERT_LT(value, 1);
    }
    ++cells[static_cast<std::size_t>(sample.pixel[0] * 4) * 4 + static_cast<std::size_t>(sample.pixel[1] * 4)];
  }
  for (const int count : cells) EXPECT_NEAR(count, 16, 6);
  EXPECT_EQ(scene_sample(0).pixel, (std::array{0.5F, 0.5F}));
  const SceneSample last = scene_sample(UINT32_MAX);
  EXPECT_LT(last.ambient[1], 1);
}

TEST(SceneView, TheCameraSeesItsTargetInTheMiddle) {
  const CameraAxes axes = camera_axes({.position = {0, 0, 4}, .target = {0, 0, 0}, .field_of_view = 90}, 2);
  EXPECT_EQ(axes.eye, (std::array{0.0F, 0.0F, 4.0F}));
  EXPECT_EQ(axes.forward, (std::array{0.0F, 0.0F, -1.0F}));
  EXPECT_NEAR(axes.right[0], 2, 1e-6);
  EXPECT_NEAR(axes.up[1], 1, 1e-6);
}

TEST(SceneView, UpMayBeTheViewItself) {
  for (const scene::Triple& position : {scene::Triple{0, 5, 0}, scene::Triple{0, -5, 0}, scene::Triple{0, 0, 5}}) {
    const scene::Triple up = position;
    const CameraAxes axes = camera_axes({.position = position, .target = {0, 0, 0}, .up = up}, 1);
    const double length = std::hypot(axes.right[0], axes.right[1], axes.right[2]);
    EXPECT_NEAR(length, std::tan(std::numbers::pi / 8), 1e-6);
  }
}

TEST(SceneView, OtherEffectsAreOtherTextsAndOtherViewsAreNot) {
  const auto text = [](const SceneLook& look) { return scene_fragment_text("source", look.effects()); };
  EXPECT_EQ(text({.view = SceneView::Shaded}), text({.view = SceneView::Steps, .light_size = 2}));
  EXPECT_NE(text({.shadows = Shadows::Hard}), text({.shadows = Shadows::Soft}));
  EXPECT_NE(text({.occlusion = false}), text({.occlusion = true}));
  EXPECT_NE(text({.view = SceneView::Shaded}), text({.view = SceneView::Lipschitz}));
}

struct Complaint {
  std::string text;
  uint32_t source;
  uint32_t line;
  std::string message;
};

TEST(ShaderComplaint, IsReadAsEachCompilerWritesIt) {
  const std::vector<Complaint> complaints{
      {"2:14: 'x' : undeclared identifier", 2, 14, "'x' : undeclared identifier"},
      {"glslang rejects the shader: 2:14: 'x' : undeclared identifier", 2, 14, "'x' : undeclared identifier"},
      {"the driver rejects the shader: 2:14(5): error: `x' undeclared", 2, 14, "error: `x' undeclared"},
      {"the driver rejects the shader: 2(14) : error C1503: undefined", 2, 14, "error C1503: undefined"}};
  for (const Complaint& expected : complaints) {
    const auto found = find_complaint(expected.text);
    ASSERT_TRUE(found) << expected.text;
    EXPECT_EQ(found->source, expected.source);
    EXPECT_EQ(found->line, expected.line);
    EXPECT_EQ(found->message, expected.message);
  }
}

TEST(ShaderComplaint, IsNothingWithoutAPlace) {
  for (const char* text : {"", "glslang rejects the shader: ", "glslang rejects the shader: Linking fragment stage",
                           "glslang rejects the shader: 3", "glslang rejects the shader: 3:", "x 1:2: y",
                           "glslang rejects the shader: 99999999999:1: x", "the driver rejects the shader: 1(2"}) {
    EXPECT_FALSE(find_complaint(text)) << text;
  }
}

}  // namespace
}  // namespace texbrdf::render
