#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "scene_support.h"

// Views of scenes against closed forms.

namespace texbrdf::render {
namespace {

using test::expect_scene_picture;
using test::kUnitSphere;
using test::scene_job;
using test::scene_source;

struct Seen {
  bool met = false;
  double distance = 0;
  std::array<double, 3> normal{};
  double miss = 0;    ///< how far the ray passes outside the unit sphere
  double cosine = 0;  ///< between the ray and -z
};

/// What the camera of scene_job (at (0, 0, 4), 45 degrees) sees of the unit sphere in the middle of a pixel.
Seen see_sphere(uint32_t size, uint32_t x, uint32_t y) {
  const double scale = std::tan(std::numbers::pi / 8);
  const double dx = ((x + 0.5) / size * 2 - 1) * scale;
  const double dy = (1 - (y + 0.5) / size * 2) * scale;
  const double length = std::sqrt(dx * dx + dy * dy + 1);
  const std::array<double, 3> d{dx / length, dy / length, -1 / length};
  const double along = -4 * d[2];
  const double beside = 16 - along * along;
  if (beside > 1) return {.miss = std::sqrt(beside) - 1, .cosine = -d[2]};
  const double t = along - std::sqrt(1 - beside);
  return {true, t, {t * d[0], t * d[1], 4 + t * d[2]}, std::sqrt(beside) - 1, -d[2]};
}

TEST(SceneViews, NormalsDepthAndSilhouetteOfASphereAreThoseOfTheClosedForm) {
  RenderWorker worker(test::worker_options());
  SceneJob job = scene_job(scene_source(kUnitSphere), 128);
  job.look.view = SceneView::Normals;
  const Picture normals = expect_scene_picture(worker, job);
  job.look.view = SceneView::Depth;
  const Picture depths = expect_scene_picture(worker, job);
  for (uint32_t y = 0; y < job.height; ++y) {
    for (uint32_t x = 0; x < job.width; ++x) {
      const Seen seen = see_sphere(job.width, x, y);
      if (std::abs(seen.miss) < 0.005) continue;
      const uint8_t* normal = normals.image.at(x, y);
      const uint8_t* depth = depths.image.at(x, y);
      if (!seen.met) {
        ASSERT_EQ(normal[0] + normal[1] + normal[2], 0) << x << ", " << y;
        ASSERT_EQ(depth[0], 0) << x << ", " << y;
        continue;
      }
      for (std::size_t c = 0; c < 3; ++c) {
        ASSERT_NEAR(normal[c], 255 * (0.5 + 0.5 * seen.normal[c]), 2) << x << ", " << y;
        ASSERT_NEAR(depth[c], 255 / (1 + std::pow(seen.distance / 4, 4)), 2) << x << ", " << y;
      }
    }
  }
}

/// The ray by itself, in double.
uint32_t count_steps(const Seen& seen, const scene::RenderSettings& settings) {
  double t = 0;
  for (uint32_t steps = 1; steps <= settings.max_steps; ++steps) {
    const double distance = std::sqrt(16 - 8 * t * seen.cosine + t * t) - 1;
    t += distance;
    if (distance < settings.surface_threshold || t > settings.max_distance) return steps;
  }
  return settings.max_steps;
}

TEST(SceneViews, StepsAreThoseOfTheRay) {
  RenderWorker worker(test::worker_options());
  SceneJob job = scene_job(scene_source(kUnitSphere));
  job.look.view = SceneView::Steps;
  job.state.settings.max_steps = 24;
  const Picture picture = expect_scene_picture(worker, job);
  const auto level = [&](uint32_t steps) { return 255 * std::log2(1.0 + steps) / std::log2(25.0); };
  bool some_run_out = false;
  for (uint32_t y = 0; y < job.height; ++y) {
    for (uint32_t x = 0; x < job.width; ++x) {
      const uint32_t steps = count_steps(see_sphere(job.width, x, y), job.state.settings);
      if (steps == 24) some_run_out = true;
      const double shown = picture.image.at(x, y)[0];
      ASSERT_GE(shown, level(steps - 1) - 1) << x << ", " << y;
      ASSERT_LE(shown, std::min(level(steps + 1), 255.0) + 1) << x << ", " << y;
    }
  }
  EXPECT_TRUE(some_run_out);
}

TEST(SceneViews, AMatteSphereFromFarAwayIsTheSphereOfDocuments) {
  RenderWorker worker(test::worker_options());
  constexpr double kAway = 1000;
  const SphereView view{.size = 64};
  SceneJob job = scene_job(scene_source(kUnitSphere));
  const auto light = light_direction(view);
  job.state.lights = {scene::DirectionalLight{{-light[0], -light[1], -light[2]}, {1, 1, 1}}};
  job.state.camera.position = {0, 0, kAway};
  job.state.camera.field_of_view = 2 * std::atan(1 / 0.9 / kAway) * 180 / std::numbers::pi;
  job.state.settings.max_distance = 2 * kAway;
  const Picture scene = expect_scene_picture(worker, job, {view.gamma, view.exposure});
  constexpr float kMatte = 0.31830989F;
  const Picture sphere = tone_map(make_sphere_geometry(view), view, {{&kMatte, &kMatte, &kMatte}, 0});
  for (std::size_t i = 0; i < sphere.image.pixels.size(); i += 4) {
    if (sphere.image.pixels[i + 3] < 255) continue;
    // Where N·L is next to 0, gamma makes a millionth of it a level.
    if (std::max(scene.image.pixels[i], sphere.image.pixels[i]) <= 4) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_NEAR(scene.image.pixels[i + c], sphere.image.pixels[i + c], 2) << "pixel " << i / 4;
    }
  }
}

TEST(SceneViews, TheTangentIsThatOfTheSphereOfDocuments) {
  RenderWorker worker(test::worker_options());
  SceneJob job = scene_job(scene_source(kUnitSphere, "(0.5 + 0.5 * X) / dot(N, L)"));
  const Picture picture = expect_scene_picture(worker, job, {1, 0});
  for (uint32_t x = 20; x < 44; ++x) {
    const Seen seen = see_sphere(job.width, x, 30);
    const double size = std::hypot(seen.normal[0], seen.normal[2]);
    const uint8_t* pixel = picture.image.at(x, 30);
    EXPECT_NEAR(pixel[0], 255 * (0.5 + 0.5 * seen.normal[2] / size), 2);
    EXPECT_NEAR(pixel[1], 127.5, 2);
    EXPECT_NEAR(pixel[2], 255 * (0.5 - 0.5 * seen.normal[0] / size), 2);
  }
}

TEST(SceneViews, CodeForAColourIsToldWhereThePixelIs) {
  RenderWorker worker(test::worker_options());
  const auto shown = [&](const std::string& colour) {
    return expect_scene_picture(worker, scene_job(scene_source(kUnitSphere, "vec3(0.0)", colour, false)), {1, 0});
  };
  const Picture place = shown("0.5 + 0.5 * properties.world_position");
  const Picture normal = shown("0.5 + 0.5 * properties.world_normal");
  const Picture ray = shown("vec3(properties.ray_distance / 10.0, -properties.ray_direction.z, 0.0)");
  const Seen seen = see_sphere(64, 40, 25);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(place.image.at(40, 25)[c], 255 * (0.5 + 0.5 * seen.normal[c]), 2);
    EXPECT_NEAR(normal.image.at(40, 25)[c], 255 * (0.5 + 0.5 * seen.normal[c]), 2);
  }
  EXPECT_NEAR(ray.image.at(40, 25)[0], 25.5 * seen.distance, 2);
  EXPECT_NEAR(ray.image.at(40, 25)[1], 255 * seen.cosine, 2);
}

TEST(SceneViews, ALyingDistanceIsLoudByHowMuch) {
  RenderWorker worker(test::worker_options());
  const auto middle = [&](const std::string& distance) {
    SceneJob job = scene_job(scene_source(distance), 32);
    job.look.view = SceneView::Lipschitz;
    const Picture picture = expect_scene_picture(worker, job);
    const uint8_t* pixel = picture.image.at(16, 16);
    return std::array<int, 3>{pixel[0], pixel[1], pixel[2]};
  };
  const auto quiet = middle(kUnitSphere);
  EXPECT_EQ(quiet[0], quiet[1]);
  EXPECT_LE(quiet[0], 64);
  const auto lying = middle("1.5 * length(p) - 1.5");
  EXPECT_EQ(lying[0], 255);
  EXPECT_NEAR(lying[1], 255 * 0.6 * (1 - std::log2(1.5)), 4);
  EXPECT_EQ(lying[2], 0);
  EXPECT_EQ(middle("8.0 * length(p) - 8.0"), (std::array{255, 255, 255}));
  const auto jump = middle("length(p) - (p.z > 2.0 ? 0.5 : 1.0)");
  EXPECT_EQ(jump[0], 255) << "a jump between two steps";
}

TEST(SceneViews, BadColoursAreMarkedAndCounted) {
  RenderWorker worker(test::worker_options());
  struct Case {
    std::string source;
    BadPixel kind;
  };
  const std::string half = "N.x > 0.0 ? vec3(%) : vec3(0.3)";
  const auto with = [&](const std::string& value) { return std::string(half).replace(half.find('%'), 1, value); };
  const std::vector<Case> cases{
      {scene_source(kUnitSphere, with("sqrt(-1.0 - abs(N.y))")), BadPixel::NotANumber},
      {scene_source(kUnitSphere, with("1.0 / (N.y - N.y)")), BadPixel::Infinite},
      {scene_source(kUnitSphere, with("-1e-30")), BadPixel::Negative},
      {scene_source(kUnitSphere, "N", "vec3(properties.world_normal.x > 0.0 ? -0.1 : 0.1)", false), BadPixel::Negative},
      {scene_source("p.x > 0.0 && length(p) < 1.05 ? sqrt(-1.0 - abs(p.y)) : length(p) - 1.0"), BadPixel::NotANumber}};
  for (const Case& bad_case : cases) {
    SceneJob job = scene_job(bad_case.source);
    job.samples = 2;
    const Picture picture = expect_scene_picture(worker, job);
    const uint32_t count = picture.bad_pixels[bad_case.kind];
    EXPECT_GT(count, 300U) << bad_case.source;
    EXPECT_LT(count, 800U) << "only half of the sphere is bad: " << bad_case.source;
    EXPECT_EQ(picture.bad_pixels.total(), count) << bad_case.source;
    const auto& colour = bad_pixel_entry(bad_case.kind).colour;
    EXPECT_TRUE(std::equal(colour.begin(), colour.end(), picture.image.at(38, 32))) << bad_case.source;
  }
}

TEST(SceneViews, SamplesSmoothTheSilhouette) {
  RenderWorker worker(test::worker_options());
  SceneJob job = scene_job(scene_source(kUnitSphere, "vec3(0.0)", "vec3(1.0)", false));
  const auto levels_between = [](const Picture& picture) {
    uint32_t count = 0;
    for (std::size_t i = 0; i < picture.image.pixels.size(); i += 4) {
      if (picture.image.pixels[i] != 0 && picture.image.pixels[i] != 255) ++count;
    }
    return count;
  };
  EXPECT_EQ(levels_between(expect_scene_picture(worker, job)), 0U);
  job.samples = 16;
  const Picture smooth = expect_scene_picture(worker, job, {1, 0});
  EXPECT_GT(levels_between(smooth), 60U);
  double sum = 0;
  for (std::size_t i = 0; i < smooth.image.pixels.size(); i += 4) sum += smooth.image.pixels[i] / 255.0;
  const double radius = 32 / std::tan(std::numbers::pi / 8) / std::sqrt(15.0);
  EXPECT_NEAR(sum, std::numbers::pi * radius * radius, 8) << "the pixels that the sphere covers";
}

}  // namespace
}  // namespace texbrdf::render
