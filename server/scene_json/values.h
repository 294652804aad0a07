#pragma once

#include "scene/scene.h"
#include "scene_json/object_reader.h"

namespace texbrdf::scene_json {

/// `{"x": 1, "y": 2, "z": 3}`
std::optional<scene::Triple> read_vector(FileReader& reader, JsonId id);
/// `[1, 0.5, 0]`, none negative
std::optional<scene::Triple> read_colour(FileReader& reader, JsonId id);
scene::Transform read_transform(FileReader& reader, JsonId id);

scene::Camera read_camera(FileReader& reader, JsonId id);
std::vector<scene::Light> read_lights(FileReader& reader, JsonId id);
scene::Environment read_environment(FileReader& reader, JsonId id);
scene::RenderSettings read_settings(FileReader& reader, JsonId id);
std::vector<scene::KeyBinding> read_keys(FileReader& reader, JsonId id);

}  // namespace texbrdf::scene_json
