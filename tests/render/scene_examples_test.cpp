#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "files/file_source.h"
#include "scene/scene_shader.h"
#include "scene_json/load_scene.h"
#include "scene_support.h"
#include "support/read_png.h"

// The scenes of docs/gallery/scenes: the pictures beside them are fresh, and none breaks its Lipschitz bounds.

namespace texbrdf::render {
namespace {

namespace fs = std::filesystem;

constexpr int kTolerance = 6;               // of 255: other drivers and instruction sets round otherwise
constexpr double kMostPixelsBeyond = 0.01;  // edges

fs::path gallery() {
  return fs::path(TEXBRDF_SOURCE_DIR) / "docs/gallery/scenes";
}

std::vector<std::string> example_names() {
  constexpr std::string_view kEnd = ".scene.json";
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(gallery())) {
    std::string name = entry.path().filename().string();
    if (name.ends_with(kEnd)) names.push_back(name.substr(0, name.size() - kEnd.size()));
  }
  std::ranges::sort(names);
  return names;
}

class SceneExample : public testing::TestWithParam<std::string> {
 protected:
  SceneExample() {
    files::DiskFiles disk;
    const auto loaded = scene_json::load_scene((gallery() / (GetParam() + ".scene.json")).string(), disk);
    for (const scene_json::Problem& problem : loaded.problems) ADD_FAILURE() << describe(problem);
    if (!loaded.scene) return;
    const scene::Scene& scene = *loaded.scene;
    job_.source = make_scene_shader(scene).source;
    job_.state = {scene.camera, scene.lights, scene.environment, scene.settings, scene_frames(scene)};
  }

  Picture draw() {
    RenderWorker worker(test::worker_options());
    return test::expect_scene_picture(worker, job_);
  }

  SceneJob job_;
};

TEST_P(SceneExample, LooksAsInTheGallery) {
  job_.width = job_.height = 200;
  job_.samples = 16;
  const Picture fresh = draw();
  EXPECT_EQ(fresh.bad_pixels.total(), 0U) << describe(fresh.bad_pixels);
  const auto tracked = test::read_png_file((gallery() / (GetParam() + ".png")).string());
  ASSERT_TRUE(tracked) << "write it with ./dev docs";
  ASSERT_EQ(tracked->pixels.size(), fresh.image.pixels.size());
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < fresh.image.pixels.size(); ++i) {
    if (std::abs(int{tracked->pixels[i]} - int{fresh.image.pixels[i]}) > kTolerance) ++beyond;
  }
  EXPECT_LE(static_cast<double>(beyond), kMostPixelsBeyond * static_cast<double>(fresh.image.pixels.size()));
}

TEST_P(SceneExample, ShowsSomething) {
  job_.width = job_.height = 64;
  job_.look.view = SceneView::Depth;
  const Picture picture = draw();
  std::size_t met = 0;
  for (std::size_t i = 0; i < picture.image.pixels.size(); i += 4) met += picture.image.pixels[i] > 0 ? 1 : 0;
  EXPECT_GT(met, 64U * 64 / 50);
}

TEST_P(SceneExample, KeepsItsLipschitzBounds) {
  job_.width = job_.height = 96;
  job_.look.view = SceneView::Lipschitz;
  const Picture picture = draw();
  for (std::size_t i = 0; i < picture.image.pixels.size(); i += 4) {
    const uint8_t* pixel = &picture.image.pixels[i];
    ASSERT_TRUE(pixel[0] == pixel[1] && pixel[1] == pixel[2] && pixel[0] <= 64)
        << "pixel " << i / 4 % 96 << ", " << i / 4 / 96;
  }
}

INSTANTIATE_TEST_SUITE_P(Gallery, SceneExample, testing::ValuesIn(example_names()), test::test_name);

}  // namespace
}  // namespace texbrdf::render
