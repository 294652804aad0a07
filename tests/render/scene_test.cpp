#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "render/png.h"
#include "scene_support.h"

// Pictures of scenes against closed forms.

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
  double miss = 0;  ///< how far the ray passes outside the unit sphere
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
  if (beside > 1) return {.miss = std::sqrt(beside) - 1};
  const double t = along - std::sqrt(1 - beside);
  return {true, t, {t * d[0], t * d[1], 4 + t * d[2]}, std::sqrt(beside) - 1};
}

TEST(SceneViews, NormalsAndDepthOfASphereAreThoseOfTheClosedForm) {
  RenderWorker worker(test::worker_options());
  SceneJob job = scene_job(scene_source(kUnitSphere), 128);
  job.look.view = SceneView::Normals;
  const Picture normals = expect_scene_picture(worker, job);
  job.look.view = SceneView::Depth;
  const Picture depths = expect_scene_picture(worker, job);
  for (uint32_t y = 0; y < job.height; ++y) {
    for (uint32_t x = 0; x < job.width; ++x) {
      const Seen seen = see_sphere(job.width, x, y);
      if (std::abs(seen.miss) < 0.01) continue;
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

}  // namespace
}  // namespace texbrdf::render
