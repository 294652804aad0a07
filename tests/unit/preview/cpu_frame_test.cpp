#include "preview/cpu_frame.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/document.h"
#include "preview/shader_model.h"

namespace texbrdf::preview {
namespace {

ir::Program program_of(const std::string& equations) {
  Document document(equations);
  auto program = document.snapshot().program("f");
  EXPECT_TRUE(program) << program.error();
  return program ? *std::move(program) : ir::Program{};
}

std::string equation(const std::string& text) {
  return "\\begin{equation}\n" + text + "\n\\end{equation}\n";
}

render::Picture draw(const std::string& equations, const render::SphereView& view) {
  const auto model = cpu_model(program_of(equations));
  EXPECT_TRUE(model) << model.error();
  render::SphereCache cache;
  return draw_on_cpu(*model, view, cache);
}

TEST(CpuFrame, ALambertianSphereHasTheCosineInItsMiddle) {
  const render::SphereView view{.size = 65, .theta = 60, .phi = 90, .gamma = 1, .exposure = 0};
  const render::Picture picture = draw(equation("f = 0.8*1"), view);
  EXPECT_EQ(picture.image.at(32, 32)[0], std::lround(255 * 0.8 * 0.5));
  EXPECT_EQ(picture.image.at(32, 32)[1], picture.image.at(32, 32)[0]);
  EXPECT_EQ(picture.image.at(32, 32)[3], 255);
  EXPECT_EQ(picture.image.at(0, 0)[3], 0);
}

TEST(CpuFrame, ChannelsAreRedGreenBlue) {
  const render::SphereView view{.size = 33, .theta = 0, .gamma = 1, .exposure = 0};
  const render::Picture picture = draw(equation("f = \\vec{0.2, 0.4, 0.6}"), view);
  const uint8_t* middle = picture.image.at(16, 16);
  EXPECT_EQ((std::array{middle[0], middle[1], middle[2]}), (std::array<uint8_t, 3>{51, 102, 153}));
}

TEST(CpuFrame, ParametersTakeTheirValues) {
  ir::Program program = program_of(equation("a = 0.2") + equation("f = a * 1"));
  ASSERT_EQ(program.parameters.size(), 1U);
  program.parameters[0].value[0] = 0.6;
  const auto model = cpu_model(program);
  ASSERT_TRUE(model);
  render::SphereCache cache;
  const render::SphereView view{.size = 33, .theta = 0, .gamma = 1, .exposure = 0};
  EXPECT_EQ(draw_on_cpu(*model, view, cache).image.at(16, 16)[0], 153);
}

TEST(CpuFrame, FramesOfTheSurfaceAreTheSpheres) {
  const render::SphereView view{.size = 64, .theta = 0, .gamma = 1, .exposure = 0};
  // The light is the viewer's direction, so phi_i is 0 on the left, where Z leans to +x of the frame, and π on the
  // right.
  const render::Picture picture = draw(equation("f = \\phi_i / 4"), view);
  EXPECT_GT(picture.image.at(52, 32)[0], 100);
  EXPECT_LT(picture.image.at(12, 32)[0], 40);
}

TEST(CpuFrame, BadPixelsAreCounted) {
  const render::Picture picture = draw(equation("f = \\frac{0}{0}"), {.size = 32});
  EXPECT_EQ(picture.bad_pixels.total(), render::make_sphere_geometry({.size = 32}).point_count());
}

TEST(ShaderModel, EveryParameterIsAUniformOfItsType) {
  const ir::Program program =
      program_of(equation("a = 0.25") + equation("\\rho_d = \\vec{0.1, 0.2, 0.3}") + equation("f = a * \\rho_d"));
  const auto model = shader_model(program);
  ASSERT_TRUE(model) << model.error();
  ASSERT_EQ(model->uniforms.size(), 2U);
  for (const render::Uniform& uniform : model->uniforms) {
    const std::string type = uniform.components == 1 ? "float" : "vec3";
    EXPECT_NE(model->source.find("uniform " + type + " " + uniform.name + ";"), std::string::npos) << model->source;
  }
  EXPECT_EQ(model->uniforms[0].value[0], 0.25F);
  EXPECT_EQ(model->uniforms[1].value, (std::array<float, 3>{0.1F, 0.2F, 0.3F}));
}

}  // namespace
}  // namespace texbrdf::preview
