#include <gtest/gtest.h>

#include <cstdlib>

#include "lighting/sky.h"
#include "objects/teapot.h"
#include "preview/object_picture.h"
#include "support.h"

// Objects and lights look the same on both devices, which are given the same points.

namespace texbrdf {
namespace {

using preview::ObjectScene;
using render::Picture;

constexpr int kTolerance = 2;  // of 255

std::shared_ptr<const objects::Mesh> teapot() {
  objects::Mesh mesh = objects::make_teapot();
  fit_into_unit_sphere(mesh);
  return std::make_shared<const objects::Mesh>(std::move(mesh));
}

Picture draw(const ObjectScene& scene, uint32_t samples, const preview::TableEvaluator& evaluate) {
  preview::ObjectPicture picture(scene);
  const auto fault = picture.add(samples, evaluate, [] { return true; });
  EXPECT_FALSE(fault) << fault->message;
  return picture.picture();
}

Picture cpu_picture(const ir::Program& program, const ObjectScene& scene, uint32_t samples = 1) {
  const auto model = preview::cpu_model(program);
  EXPECT_TRUE(model) << model.error();
  return draw(scene, samples, preview::evaluator_on_cpu(*model));
}

Picture gpu_picture(const ir::Program& program, const ObjectScene& scene, uint32_t samples = 1) {
  const auto model = preview::shader_model(program);
  EXPECT_TRUE(model) << model.error();
  render::RenderWorker worker(test::worker_options());
  return draw(scene, samples, preview::evaluator_on_gpu(worker, *model));
}

/// Over all but pixels of a colour for bad values; those are compared by their number.
int largest_difference(const Picture& a, const Picture& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.image.pixels.size(); ++i) {
    largest = std::max(largest, std::abs(int{a.image.pixels[i]} - int{b.image.pixels[i]}));
  }
  return largest;
}

class Object : public testing::TestWithParam<std::string> {};

TEST_P(Object, LooksTheSameOnBothDevices) {
  const ir::Program program = test::model_program(GetParam());
  const ObjectScene scene{{.size = 128}, {teapot(), {-30, 20}}, nullptr};
  const Picture cpu = cpu_picture(program, scene);
  const Picture gpu = gpu_picture(program, scene);
  if (cpu.bad_pixels.total() == 0) {
    EXPECT_LE(largest_difference(cpu, gpu), kTolerance);
  }
  EXPECT_NEAR(cpu.bad_pixels.total(), gpu.bad_pixels.total(), cpu.bad_pixels.total() * 0.01);
}

INSTANTIATE_TEST_SUITE_P(Agreement, Object, testing::ValuesIn(test::model_names()), test::test_name);

/// All samples of both are at the same places; bad values are left out of neither.
TEST(Object, LooksTheSameInTheSkyOnBothDevices) {
  const auto sky = std::make_shared<const lighting::Environment>(lighting::make_sky({}));
  for (const char* name : {"oren-nayar", "ward", "cook-torrance"}) {
    const ir::Program program = test::model_program(name);
    const ObjectScene scene{{.size = 64}, {teapot(), {-30, 20}}, sky};
    EXPECT_LE(largest_difference(cpu_picture(program, scene, 8), gpu_picture(program, scene, 8)), kTolerance) << name;
  }
}

TEST(Object, ASphereWithoutAMeshIsThatOfTheSphereView) {
  const ir::Program program = test::model_program("cook-torrance");
  const render::SphereView view{.size = 128};
  const auto model = preview::cpu_model(program);
  ASSERT_TRUE(model);
  render::SphereCache cache;
  const Picture sphere = preview::draw_on_cpu(*model, view, cache);
  EXPECT_LE(largest_difference(sphere, cpu_picture(program, {view, {}, nullptr})), 1);
}

TEST(Object, ATeapotIsSeen) {
  const auto program = test::program_of(test::document_of("\\frac{1}{\\pi}"));
  ASSERT_TRUE(program);
  const Picture picture = cpu_picture(*program, {{.size = 64}, {teapot(), {}}, nullptr});
  const auto alpha = [&](std::size_t row, std::size_t column) {
    return picture.image.pixels[(row * 64 + column) * 4 + 3];
  };
  EXPECT_EQ(alpha(32, 32), 255);  // its body
  EXPECT_EQ(alpha(30, 5), 255);   // its handle, on the left
  EXPECT_EQ(alpha(32, 8), 0);     // what the handle encloses
  EXPECT_EQ(alpha(2, 32), 0);
  EXPECT_EQ(picture.bad_pixels.total(), 0);
}

}  // namespace
}  // namespace texbrdf
