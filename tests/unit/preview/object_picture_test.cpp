#include "preview/object_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "lighting/sky.h"
#include "objects/teapot.h"
#include "preview/object_choice.h"
#include "unit/preview/exact.h"

namespace texbrdf::preview {
namespace {

using lighting::Environment;
using EnvironmentPointer = std::shared_ptr<const Environment>;
using MeshPointer = std::shared_ptr<const objects::Mesh>;

constexpr auto kAlways = [] { return true; };

EnvironmentPointer furnace() {
  return std::make_shared<const Environment>(Environment::furnace());
}

EnvironmentPointer sky() {
  return std::make_shared<const Environment>(lighting::make_sky({}));
}

MeshPointer teapot() {
  return *find_mesh("teapot", [](const std::string&) { return Failure{"no files"}; });
}

CpuModel lambert(const std::string& colour) {
  auto model = cpu_model(program_of(equation("f = " + colour + " * 1 / \\pi")));
  EXPECT_TRUE(model) << model.error();
  return *std::move(model);
}

ObjectScene scene_of(const render::SphereView& view, const SeenObject& object, const EnvironmentPointer& environment) {
  ObjectScene scene;
  scene.view = view;
  scene.object = object;
  scene.environment = environment;
  return scene;
}

ObjectPicture draw(const ObjectScene& scene, const CpuModel& model, uint32_t samples) {
  ObjectPicture picture(scene);
  EXPECT_FALSE(picture.add(samples, evaluator_on_cpu(model), kAlways));
  return picture;
}

TEST(ObjectPicture, InAFurnaceALambertianHasItsReflectanceEverywhere) {
  const CpuModel model = lambert("\\vec{0.2, 0.5, 0.9}");
  for (const MeshPointer& mesh : {MeshPointer(), teapot()}) {
    // Each sample of each pixel has the same value: nothing is left to chance.
    const ObjectPicture picture = draw(scene_of({.size = 48}, {mesh, {-30, 20}}, furnace()), model, 5);
    const render::Picture shown = picture.picture();
    const std::vector<glm::dvec3> radiance = picture.radiance();
    for (std::size_t i = 0; i < radiance.size(); ++i) {
      if (shown.image.pixels[i * 4 + 3] == 0) continue;
      EXPECT_NEAR(radiance[i].x, 0.2, 1e-6);
      EXPECT_NEAR(radiance[i].y, 0.5, 1e-6);
      EXPECT_NEAR(radiance[i].z, 0.9, 1e-6);
    }
  }
}

/// A roof of two squares that meet in the middle of a column of pixels.
MeshPointer roof() {
  objects::Mesh mesh;
  const glm::vec3 left = glm::normalize(glm::vec3(-1, 0, 1));
  const glm::vec3 right = glm::normalize(glm::vec3(1, 0, 1));
  for (const auto& [x, normal] : {std::pair(-1.F, left), {0.F, left}, {0.F, right}, {1.F, right}}) {
    for (const float y : {-1.F, 1.F}) mesh.vertices.push_back({{x, y, -std::abs(x)}, normal, {0, 1, 0}});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 6, 7}, {4, 7, 5}};
  return std::make_shared<const objects::Mesh>(std::move(mesh));
}

/// One bright texel at the right, nearly nothing else: what faces left sees little of it.
EnvironmentPointer lamp() {
  lighting::EnvironmentMap map{32, 16, std::vector<glm::vec3>(512, glm::vec3(0.01F))};
  map.radiance[7 * 32 + 24] = glm::vec3(100);
  return std::make_shared<const Environment>(std::move(map));
}

double mean_of_column(const ObjectPicture& picture, uint32_t size, uint32_t column) {
  const std::vector<glm::dvec3> radiance = picture.radiance();
  double sum = 0;
  for (uint32_t row = size / 4; row < size - size / 4; ++row) sum += radiance[row * size + column].x;
  return sum / (size / 2);
}

TEST(ObjectPicture, APixelOfTwoFacesHasTheMeanOfBoth) {
  constexpr uint32_t kSize = 101;
  const ObjectPicture picture = draw(scene_of({.size = kSize}, {roof(), {}}, lamp()), lambert("0.5"), 256);
  const double left = mean_of_column(picture, kSize, kSize / 2 - 1);
  const double right = mean_of_column(picture, kSize, kSize / 2 + 1);
  EXPECT_GT(right, 3 * left);
  // Two of its four rays are on either side.
  EXPECT_NEAR(mean_of_column(picture, kSize, kSize / 2), (left + right) / 2, 0.02 * right);
  const std::vector<glm::dvec3> radiance = picture.radiance();
  for (uint32_t row = kSize / 4; row < kSize / 2; ++row) {
    EXPECT_NEAR(radiance[row * kSize + kSize / 2].x, (left + right) / 2, 0.2 * right) << row;
  }
}

TEST(ObjectPicture, TurningTheViewerTurnsTheLightWithTheObject) {
  // Level ground in the sky has the irradiance π from wherever it is seen.
  objects::Mesh mesh;
  for (const auto& [x, z] : {std::pair(-1.F, -1.F), {-1.F, 1.F}, {1.F, 1.F}, {1.F, -1.F}}) {
    mesh.vertices.push_back({{x, 0, z}, {0, 1, 0}, {1, 0, 0}});
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const auto ground = std::make_shared<const objects::Mesh>(std::move(mesh));
  for (const objects::Orbit& orbit : {objects::Orbit{0, 90}, {120, 40}, {-45, 10}}) {
    const ObjectPicture picture = draw(scene_of({.size = 64, .zoom = 20}, {ground, orbit}, sky()), lambert("0.5"), 64);
    glm::dvec3 sum(0);
    for (const glm::dvec3& pixel : picture.radiance()) sum += pixel;
    EXPECT_NEAR(lighting::luminance(sum) / (64 * 64), 0.5, 0.005) << orbit.yaw;
  }
}

TEST(ObjectPicture, IsTheSameAgainAndHoweverItsSamplesComeTogether) {
  const CpuModel model = lambert("0.5");
  const ObjectScene scene = scene_of({.size = 40}, {teapot(), {10, 30}}, sky());
  const ObjectPicture at_once = draw(scene, model, 12);
  ObjectPicture in_parts(scene);
  for (const uint32_t count : {1U, 3U, 8U}) EXPECT_FALSE(in_parts.add(count, evaluator_on_cpu(model), kAlways));
  EXPECT_EQ(in_parts.samples(), 12);
  EXPECT_EQ(at_once.picture().image.pixels, in_parts.picture().image.pixels);
}

TEST(ObjectPicture, MoreSamplesHaveLessNoise) {
  const CpuModel model = lambert("0.5");
  const ObjectScene scene = scene_of({.size = 40}, {nullptr, {}}, sky());
  const std::vector<glm::dvec3> best = draw(scene, model, 4096).radiance();
  const auto error = [&](uint32_t samples) {
    const std::vector<glm::dvec3> some = draw(scene, model, samples).radiance();
    double sum = 0;
    for (std::size_t i = 0; i < some.size(); ++i) sum += glm::dot(some[i] - best[i], some[i] - best[i]);
    return std::sqrt(sum);
  };
  EXPECT_LT(error(256), error(16) / 4);
}

TEST(ObjectPicture, IsGivenUpWhenNobodyWantsIt) {
  int asked = 0;
  const CpuModel model = lambert("0.5");
  const TableEvaluator evaluate = [&](const render::GeometryTable& geometries) {
    ++asked;
    return evaluator_on_cpu(model)(geometries);
  };
  ObjectPicture picture(scene_of({.size = 512}, {}, furnace()));
  EXPECT_FALSE(picture.add(1000, evaluate, [] { return false; }));
  EXPECT_EQ(asked, 1);
}

TEST(ObjectPicture, TellsWhyItFailed) {
  ObjectPicture picture(scene_of({.size = 32}, {}, furnace()));
  const auto fault = picture.add(
      2, [](const render::GeometryTable&) { return render::RenderFault{render::RenderFaultKind::Crash, "gone"}; },
      kAlways);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->message, "gone");
}

TEST(ObjectPicture, BadValuesAreMarkedAndCounted) {
  const auto model = cpu_model(program_of(equation("f = 0 - 1")));
  ASSERT_TRUE(model);
  const render::Picture picture = draw(scene_of({.size = 32}, {teapot(), {}}, furnace()), *model, 1).picture();
  EXPECT_GT(picture.bad_pixels[render::BadPixel::Negative], 50);
}

TEST(ObjectChoice, NamesAndFilesAreFound) {
  const FileReader read = [](const std::string& path) -> Result<std::string> {
    if (path == "a.obj") return std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    if (path == "b.hdr") return std::string("#?RADIANCE\n\n-Y 1 +X 2\n\x80\x80\x80\x80\x80\x80\x80\x80");
    return Failure{"cannot read " + path};
  };
  EXPECT_FALSE(*find_mesh("sphere", read));
  EXPECT_EQ((*find_mesh("a.obj", read))->triangles.size(), 1);
  EXPECT_EQ(find_mesh("c.obj", read).error(), "cannot read c.obj");
  EXPECT_FALSE(find_mesh("cup", read));
  EXPECT_FALSE(*find_environment({"directional", {}}, read));
  EXPECT_EQ((*find_environment({"b.hdr", {}}, read))->map().width, 2);
  EXPECT_EQ(find_environment({"c.hdr", {}}, read).error(), "cannot read c.hdr");
  EXPECT_FALSE(find_environment({"moon", {}}, read));
  EXPECT_FALSE(find_environment({"sky", {45, 0, 99}}, read));
}

}  // namespace
}  // namespace texbrdf::preview
