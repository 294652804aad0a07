#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace texbrdf::scene {

/// What the renderer puts its tracer around.
struct SceneShader {
  /// GLSL 3.30 without `#version` and `main`. It declares
  ///
  ///     uniform vec4 scene_frames[N];
  ///     struct FragmentProperties { vec3 world_position, object_position, world_normal, ray_direction;
  ///                                 float ray_distance; };
  ///     bool scene_guarded;
  ///     vec2 scene_distance(vec3 place);
  ///     int scene_material(int leaf);
  ///     vec3 scene_origin(int leaf);
  ///     bool scene_is_lit(int material);
  ///     vec3 scene_brdf(int material, vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y);
  ///     vec3 scene_shade(int material, FragmentProperties properties);
  ///
  /// N is scene_frames(scene).size() / 4; without dynamic objects there is no such uniform. scene_distance gives a
  /// bound of the distance, whose slope is at most 1, and the leaf that is nearest. While scene_guarded is true, which
  /// it is at first, boxes stand for what is far: that is faster, and less than the distance around them.
  /// scene_material is an index into Scene::materials, or one more: the default material. scene_origin is where a
  /// leaf's own origin is in the world. What is lit has a BRDF, scene_brdf, and gets the light of the scene; else
  /// scene_shade is its colour. Every name that the tracer may use for itself begins with `trace_`; code of users
  /// cannot clash with either.
  std::string source;
  std::vector<CodePlace> places;      ///< of code of users: in `#line LINE N` of the source, N is 1 + the index here
  std::vector<std::string> prefixes;  ///< what that code's own names begin with in the source; by the same index
};

/// The scene has no fault.
SceneShader make_scene_shader(const Scene& scene);

/// What a GLSL compiler says of code of a user, with the names as they stand in that. `source` is the N of its `#line`.
std::string in_names_of_user(const SceneShader& shader, uint32_t source, std::string_view message);

/// The uniform array for the present transforms of the dynamic objects: moving one sends it anew and compiles nothing.
std::vector<float> scene_frames(const Scene& scene);

}  // namespace texbrdf::scene
