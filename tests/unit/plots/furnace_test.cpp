#include <cmath>

#include "plots/albedo.h"
#include "preview/object_picture.h"
#include "support/read_file.h"
#include "unit/preview/exact.h"

// What a plate reflects in a furnace is the directional albedo of a BRDF in which light and viewer may be exchanged.

namespace texbrdf::plots {
namespace {

using lighting::Environment;

/// Fills the picture.
std::shared_ptr<const objects::Mesh> plate() {
  objects::Mesh mesh;
  for (const auto& [x, y] : {std::pair(-1.F, -1.F), {1.F, -1.F}, {1.F, 1.F}, {-1.F, 1.F}}) {
    mesh.vertices.push_back({{x, y, 0}, {0, 0, 1}, {1, 0, 0}});
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return std::make_shared<const objects::Mesh>(std::move(mesh));
}

struct Mean {
  double value = 0;
  double error = 0;  ///< standard error, from the spread of the pixels
};

/// Red, seen at an angle from the normal.
Mean reflected(const ir::Program& program, double angle) {
  const auto model = preview::cpu_model(program);
  EXPECT_TRUE(model) << model.error();
  const auto furnace = std::make_shared<const Environment>(Environment::furnace());
  preview::ObjectPicture picture({{.size = 64, .zoom = 100}, {plate(), {angle, 0}}, furnace});
  EXPECT_FALSE(picture.add(128, preview::evaluator_on_cpu(*model), [] { return true; }));
  const std::vector<glm::dvec3> pixels = picture.radiance();
  double sum = 0;
  double squares = 0;
  for (const glm::dvec3& pixel : pixels) {
    sum += pixel.x;
    squares += pixel.x * pixel.x;
  }
  const auto count = static_cast<double>(pixels.size());
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean) / count)};
}

class Furnace : public testing::TestWithParam<std::string> {};

TEST_P(Furnace, ReflectsTheDirectionalAlbedo) {
  const ir::Program program =
      preview::program_of(test::read_file(std::string(TEXBRDF_TEST_DATA) + "/models/" + GetParam() + ".tex"));
  const Curve albedo = sample_albedo(preview::model_of(program), {.view = View::Albedo}, {.steps = 400'000'000});
  ASSERT_EQ(albedo.angles.size(), 90U);
  for (const std::size_t angle : {5U, 30U, 60U}) {
    const Mean mean = reflected(program, static_cast<double>(angle));
    const double expected = (*albedo.values[angle])[0];
    EXPECT_NEAR(mean.value, expected, 5 * mean.error + albedo.errors[angle][0] + 1e-5 * expected) << angle;
    EXPECT_LT(mean.error, 0.02 * expected) << angle;
  }
}

INSTANTIATE_TEST_SUITE_P(Models, Furnace, testing::Values("oren-nayar", "blinn-phong", "cook-torrance", "ward"),
                         [](const auto& model) {
                           std::string name = model.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace texbrdf::plots
