#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/file_source.h"
#include "scene/scene.h"
#include "scene_json/problem.h"

namespace texbrdf::scene_json {

inline constexpr std::size_t kMaxFiles = 256;

/// A scene as its files tell it.
struct LoadedScene {
  std::optional<scene::Scene> scene;  ///< nothing where there is an error
  std::vector<Problem> problems;
  std::vector<std::string> files;  ///< real paths of all that it depends on, those included that are missing: a change
                                   ///< of one of them can change the scene
};

/// Reads a *.scene.json and all that it names. A model, a material, a shader, a primitive, or a document with a BRDF is
/// read too: a material is shown on a sphere.
LoadedScene load_scene(const std::string& path, files::FileSource& files);

}  // namespace texbrdf::scene_json
