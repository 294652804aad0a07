#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "render/worker_client.h"
#include "scene/scene_shader.h"
#include "scene_json/load_scene.h"

namespace texbrdf::test {

inline std::vector<std::string> example_scenes() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(TEXBRDF_SOURCE_DIR "/docs/gallery/scenes")) {
    const std::string name = entry.path().filename().string();
    const std::size_t end = name.find(".scene.json");
    if (end != std::string::npos) names.push_back(name.substr(0, end));
  }
  std::sort(names.begin(), names.end());
  return names;
}

inline scene::Scene load_example(const std::string& name) {
  files::DiskFiles disk;
  auto loaded = scene_json::load_scene(TEXBRDF_SOURCE_DIR "/docs/gallery/scenes/" + name + ".scene.json", disk);
  for (const auto& problem : loaded.problems) ADD_FAILURE() << describe(problem);
  return std::move(loaded.scene).value();
}

/// The scene's shader as a model whose value is the distance and the leaf at L.
inline render::ShaderModel distance_model(const scene::SceneShader& shader) {
  return {
      shader.source + "vec3 brdf(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return vec3(scene_distance(L), 0.0); }\n",
      {}};
}

}  // namespace texbrdf::test
