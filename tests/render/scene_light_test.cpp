#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "scene_support.h"

// Shadows, ambient light and its occlusion: a ball of radius 0.5 at (0, 1, 0) above the floor y = 0.

namespace texbrdf::render {
namespace {

using test::expect_scene_picture;
using test::scene_job;
using test::scene_source;

constexpr const char* kBallOverFloor = "min(p.y, length(p - vec3(0.0, 1.0, 0.0)) - 0.5)";
const glm::dvec3 kBall{0, 1, 0};
const glm::dvec3 kEye{0, 3, 5};
const glm::dvec3 kTowardsLight = glm::normalize(glm::dvec3(-1, 1.5, 0.3));

SceneJob ball_over_floor() {
  SceneJob job = scene_job(scene_source(kBallOverFloor), 96);
  job.state.camera.position = {kEye.x, kEye.y, kEye.z};
  job.state.camera.target = {0.5, 0, 0};
  job.state.lights = {scene::DirectionalLight{{-kTowardsLight.x, -kTowardsLight.y, -kTowardsLight.z}, {3, 3, 3}}};
  return job;
}

/// Where the ray in the middle of a pixel meets the floor, if it does not meet the ball or pass close to it.
std::optional<glm::dvec3> floor_place(const SceneJob& job, uint32_t x, uint32_t y) {
  const CameraAxes axes = camera_axes(job.state.camera, 1);
  const auto vector = [](const std::array<float, 3>& v) { return glm::dvec3(v[0], v[1], v[2]); };
  const double dx = (x + 0.5) / job.width * 2 - 1;
  const double dy = 1 - (y + 0.5) / job.height * 2;
  const glm::dvec3 ray = glm::normalize(vector(axes.forward) + dx * vector(axes.right) + dy * vector(axes.up));
  if (ray.y >= -0.05 || glm::length(glm::cross(kBall - kEye, ray)) < 0.52) return std::nullopt;
  return kEye - ray * (kEye.y / ray.y);
}

/// How far the light's ray to a place of the floor passes from the middle of the ball.
double passes_at(const glm::dvec3& place) {
  return glm::length(glm::cross(kBall - place, kTowardsLight));
}

TEST(SceneLight, AHardShadowEndsWhereTheBallDoes) {
  RenderWorker worker(test::worker_options());
  const SceneJob job = ball_over_floor();
  const Picture picture = expect_scene_picture(worker, job, {1, -1});
  uint32_t dark = 0;
  for (uint32_t y = 0; y < job.height; ++y) {
    for (uint32_t x = 0; x < job.width; ++x) {
      const auto place = floor_place(job, x, y);
      if (!place || std::abs(passes_at(*place) - 0.5) < 0.01) continue;
      const bool is_dark = passes_at(*place) < 0.5;
      const double expected = is_dark ? 0 : 255 * 3 * kTowardsLight.y / std::numbers::pi / 2;
      ASSERT_NEAR(picture.image.at(x, y)[0], expected, 2) << x << ", " << y;
      if (is_dark) ++dark;
    }
  }
  EXPECT_GT(dark, 100U);
}

TEST(SceneLight, WithoutShadowsTheFloorIsAsBrightEverywhere) {
  RenderWorker worker(test::worker_options());
  SceneJob job = ball_over_floor();
  job.look.shadows = Shadows::None;
  const Picture picture = expect_scene_picture(worker, job, {1, -1});
  for (uint32_t x = 0; x < job.width; ++x) {
    if (!floor_place(job, x, 90)) continue;
    ASSERT_NEAR(picture.image.at(x, 90)[0], 255 * 3 * kTowardsLight.y / std::numbers::pi / 2, 2);
  }
}

TEST(SceneLight, ASoftShadowGetsBrighterOutwardsAndWiderWithTheLight) {
  RenderWorker worker(test::worker_options());
  SceneJob job = ball_over_floor();
  const Picture hard = expect_scene_picture(worker, job, {1, -1});
  job.look.shadows = Shadows::Soft;
  std::array<uint32_t, 2> half_lit{};
  for (std::size_t i = 0; i < half_lit.size(); ++i) {
    job.look.light_size = i == 0 ? 3 : 15;
    const Picture soft = expect_scene_picture(worker, job, {1, -1});
    std::vector<std::pair<double, int>> by_distance;
    for (uint32_t y = 0; y < job.height; ++y) {
      for (uint32_t x = 0; x < job.width; ++x) {
        const auto place = floor_place(job, x, y);
        if (!place) continue;
        const int level = soft.image.at(x, y)[0];
        ASSERT_LE(level, hard.image.at(x, y)[0] + 1) << x << ", " << y;
        if (level > 2 && level + 2 < hard.image.at(x, y)[0]) ++half_lit[i];
        // At the same distance from the ball, so that only how far the ray passes differs.
        if (std::abs(glm::dot(kBall - *place, kTowardsLight) - 1.2) < 0.05) {
          by_distance.emplace_back(passes_at(*place), level);
        }
      }
    }
    std::ranges::sort(by_distance);
    ASSERT_GT(by_distance.size(), 20U);
    for (std::size_t k = 1; k < by_distance.size(); ++k) {
      ASSERT_GE(by_distance[k].second + 6, by_distance[k - 1].second) << by_distance[k].first;
    }
  }
  EXPECT_GT(half_lit[0], 20U);
  EXPECT_GT(half_lit[1], 2 * half_lit[0]);
}

TEST(SceneLight, APointLightFallsWithTheSquareOfTheDistance) {
  RenderWorker worker(test::worker_options());
  SceneJob job = scene_job(scene_source("p.y"), 32);
  job.state.camera = {.position = {0, 4, 0.001}, .target = {0, 0, 0}};
  job.state.lights = {scene::PointLight{{0.5, 2, 0}, {8, 6, 4}}};
  const Picture picture = expect_scene_picture(worker, job, {1, 0});
  for (uint32_t x = 0; x < job.width; ++x) {
    const double at = 4 * std::tan(std::numbers::pi / 8) * ((x + 0.5) / job.width * 2 - 1);
    const double across = 4 * std::tan(std::numbers::pi / 8) / job.width;
    const double squared = 4 + (at - 0.5) * (at - 0.5) + across * across;
    const double cosine = 2 / std::sqrt(squared);
    ASSERT_NEAR(picture.image.at(x, 16)[0], 255 * 8 * cosine / squared / std::numbers::pi, 2) << x;
    ASSERT_NEAR(picture.image.at(x, 16)[2], 255 * 4 * cosine / squared / std::numbers::pi, 2) << x;
  }
}

TEST(SceneLight, AmbientLightOnMatteIsItsReflectance) {
  RenderWorker worker(test::worker_options());
  SceneJob job = ball_over_floor();
  job.state.lights.clear();
  job.state.environment.ambient = {0.2, 0.5, 0.8};
  const Picture picture = expect_scene_picture(worker, job, {1, 0});
  for (const uint32_t y : {50U, 90U}) {
    EXPECT_NEAR(picture.image.at(48, y)[0], 51, 1);
    EXPECT_NEAR(picture.image.at(48, y)[1], 127.5, 1);
    EXPECT_NEAR(picture.image.at(48, y)[2], 204, 1);
  }
}

/// f = (N·L + 1) / π: the mean of cosθ over a cosine lobe is 2/3.
TEST(SceneLight, AmbientLightComesFromAllSides) {
  RenderWorker worker(test::worker_options());
  SceneJob job = scene_job(scene_source("p.z", "vec3(dot(N, L)) * 0.31830989"), 4);
  job.state.lights.clear();
  job.state.environment.ambient = {0.6, 0.6, 0.6};
  job.samples = 64;
  const Picture picture = expect_scene_picture(worker, job, {1, 0});
  EXPECT_NEAR(picture.image.at(2, 2)[0], 255 * 0.6 * 2 / 3, 2);
}

TEST(SceneLight, OcclusionDarkensWhereTheBallIsNearAndNowhereElse) {
  RenderWorker worker(test::worker_options());
  SceneJob job = ball_over_floor();
  job.source = scene_source("min(p.y, length(p - vec3(0.0, 0.5, 0.0)) - 0.5)");
  job.state.lights.clear();
  job.state.environment.ambient = {0.8, 0.8, 0.8};
  job.look.occlusion = true;
  job.look.occlusion_radius = 0.4;
  const Picture picture = expect_scene_picture(worker, job, {1, 0});
  int darkest = 255;
  for (uint32_t y = 0; y < job.height; ++y) {
    for (uint32_t x = 0; x < job.width; ++x) {
      const auto place = floor_place(job, x, y);
      if (!place) continue;
      const double from_ball = std::hypot(place->x, place->z);
      if (from_ball > 1) {
        ASSERT_NEAR(picture.image.at(x, y)[0], 204, 1) << x << ", " << y;
      } else if (from_ball < 0.6 && picture.image.at(x, y)[0] > 0) {
        darkest = std::min<int>(darkest, picture.image.at(x, y)[0]);
      }
    }
  }
  EXPECT_LT(darkest, 150);
}

}  // namespace
}  // namespace texbrdf::render
