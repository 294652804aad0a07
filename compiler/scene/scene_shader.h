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
  ///   uniform vec4 scene_frames[N];  // N = scene_frames(scene).size() / 4; not declared if no object is dynamic
  ///   struct FragmentProperties { vec3 world_position, object_position, world_normal, ray_direction; float
  ///   ray_distance; }; vec2 scene_distance(vec3 place);  // x: slope at most 1, so at most the distance; y: the leaf
  ///   that is nearest int scene_material(int leaf);     // an index into Scene::materials, or what is one more: the
  ///   default material vec3 scene_origin(int leaf);      // where the leaf's own origin is in the world bool
  ///   scene_is_lit(int material);  // true: scene_brdf is its BRDF, lit by the lights; false: scene_shade is its
  ///   colour vec3 scene_brdf(int material, vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y); vec3 scene_shade(int material,
  ///   FragmentProperties properties);
  /// Every name that the tracer may use for itself begins with `trace_`; code of users cannot clash with either.
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
