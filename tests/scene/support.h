#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "render/support.h"
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

/// A model whose value is distance and leaf at L. The transforms of dynamic objects are constants: evaluation has no
/// arrays of uniforms.
inline render::ShaderModel distance_model(const scene::Scene& scene) {
  std::string source = make_scene_shader(scene).source;
  const std::vector<float> frames = scene_frames(scene);
  if (!frames.empty()) {
    std::string values;
    for (std::size_t i = 0; i < frames.size(); i += 4) {
      values += fmt::format("{}vec4({}, {}, {}, {})", i == 0 ? "" : ", ", frames[i], frames[i + 1], frames[i + 2],
                            frames[i + 3]);
    }
    const std::string declared = fmt::format("uniform vec4 scene_frames[{}];", frames.size() / 4);
    source.replace(source.find(declared), declared.size(),
                   fmt::format("const vec4 scene_frames[{}] = vec4[]({});", frames.size() / 4, values));
  }
  return {source + "vec3 brdf(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return vec3(scene_distance(L), 0.0); }\n", {}};
}

}  // namespace texbrdf::test
