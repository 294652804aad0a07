#include "scene_json/load_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "scene_json/object_reader.h"
#include "support/read_file.h"

namespace texbrdf::scene_json {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> files_in(const std::string& folder) {
  std::vector<std::string> paths;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string problems_of(const LoadedScene& loaded, const std::string& folder) {
  std::string text;
  for (const Problem& problem : loaded.problems) text += describe(problem, files::real_path(folder)) + "\n";
  return text;
}

TEST(LoadScene, EveryExampleIsRead) {
  const std::string folder = TEXBRDF_SOURCE_DIR "/docs/gallery/scenes";
  const std::vector<std::string> paths = files_in(folder);
  EXPECT_GE(paths.size(), 25U);
  for (const std::string& path : paths) {
    files::DiskFiles disk;
    const LoadedScene loaded = load_scene(path, disk);
    EXPECT_EQ(problems_of(loaded, folder), "") << path;
    ASSERT_TRUE(loaded.scene) << path;
    EXPECT_FALSE(loaded.scene->roots.empty()) << path;
  }
}

TEST(LoadScene, EveryBrokenFileSaysWhatIsWrong) {
  const std::string folder = TEXBRDF_TEST_DATA "/scenes/broken";
  uint32_t count = 0;
  for (const std::string& path : files_in(folder)) {
    const fs::path expected = fs::path(path).replace_extension(".expected");
    if (!fs::exists(expected)) continue;  // a part of another
    files::DiskFiles disk;
    const LoadedScene loaded = load_scene(path, disk);
    EXPECT_FALSE(loaded.scene) << path;
    if (std::getenv("GOLDEN_UPDATE") != nullptr) std::ofstream(expected) << problems_of(loaded, folder);
    EXPECT_EQ(problems_of(loaded, folder), test::read_file(expected.string())) << path;
    ++count;
  }
  EXPECT_GE(count, 20U);
}

TEST(LoadScene, AModelsNodesComeBelowTheirParents) {
  files::DiskFiles disk;
  const LoadedScene loaded = load_scene(TEXBRDF_SOURCE_DIR "/docs/gallery/scenes/both_models.scene.json", disk);
  ASSERT_TRUE(loaded.scene);
  const scene::Scene& scene = *loaded.scene;
  ASSERT_EQ(scene.roots.size(), 2U);
  ASSERT_EQ(scene.nodes.size(), 7U);
  const scene::Node& moved = scene.node(scene.roots[0]);
  EXPECT_EQ(moved.transform.position, (scene::Triple{-0.8, 0, 0}));
  ASSERT_EQ(moved.children.size(), 1U);
  const scene::Node& sphere = scene.node(moved.children[0]);
  EXPECT_EQ(sphere.kind, scene::ObjectKind::Sphere);
  EXPECT_EQ(sphere.transform.scale, (scene::Triple{1, 2, 4}));
  EXPECT_EQ(sphere.data[0], 0.5);
  EXPECT_EQ(scene.node(scene.node(scene.roots[1]).children[0]).children.size(), 3U);
  for (uint32_t i = 0; i < scene.nodes.size(); ++i) {
    for (const scene::NodeId child : scene.nodes[i].children) EXPECT_LT(child.value, i);
  }
}

TEST(LoadScene, TellsTheFilesThatItDependsOn) {
  files::DiskFiles disk;
  const LoadedScene loaded = load_scene(TEXBRDF_SOURCE_DIR "/docs/gallery/scenes/both_models.scene.json", disk);
  std::vector<std::string> names;
  for (const std::string& path : loaded.files) names.push_back(fs::path(path).filename().string());
  EXPECT_EQ(names, (std::vector<std::string>{"both_models.scene.json", "lit.shader.json", "one_sphere.model.json",
                                             "three_spheres.model.json"}));
}

TEST(LoadScene, ADocumentIsAShaderWithItsConstants) {
  files::DiskFiles disk;
  const LoadedScene loaded = load_scene(TEXBRDF_SOURCE_DIR "/docs/gallery/scenes/steered.scene.json", disk);
  ASSERT_TRUE(loaded.scene);
  const scene::Scene& scene = *loaded.scene;
  ASSERT_EQ(scene.shaders.size(), 2U);
  EXPECT_EQ(scene.shaders[0].kind, scene::ShaderKind::Brdf);
  EXPECT_FALSE(scene.shaders[0].properties.empty());
  EXPECT_NE(scene.shaders[0].code.find("vec3 brdf("), std::string::npos);
  EXPECT_EQ(scene.materials[0].values.size(), scene.shaders[0].properties.size());
  EXPECT_EQ(scene.user_primitives.at(0).name, "wavy_floor");
  EXPECT_EQ(scene.user_primitives.at(0).place.first_line, 7U);
  ASSERT_TRUE(scene.nodes[0].dynamic);
  EXPECT_EQ(scene.nodes[0].dynamic->name, "ball");
  EXPECT_EQ(scene.nodes[0].dynamic->keys.size(), 4U);
}

}  // namespace
}  // namespace texbrdf::scene_json
