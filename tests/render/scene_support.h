#pragma once

#include <string>

#include "render/scene_picture.h"
#include "support.h"

namespace texbrdf::test {

/// The source of a scene whose distance function is one expression of `p`, all of material 0.
inline std::string scene_source(const std::string& distance, const std::string& brdf = "vec3(0.31830989)",
                                const std::string& colour = "vec3(0.5)", bool is_lit = true) {
  return "struct FragmentProperties { vec3 world_position, object_position, world_normal, ray_direction; "
         "float ray_distance; };\n"
         "bool scene_guarded = true;\n"
         "vec2 scene_distance(vec3 p) { return vec2(" +
         distance +
         ", 0.0); }\n"
         "int scene_material(int leaf) { return 0; }\n"
         "vec3 scene_origin(int leaf) { return vec3(0.0); }\n"
         "bool scene_is_lit(int material) { return " +
         (is_lit ? "true" : "false") +
         "; }\n"
         "vec3 scene_brdf(int material, vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return " +
         brdf +
         "; }\n"
         "vec3 scene_shade(int material, FragmentProperties properties) { return " +
         colour + "; }\n";
}

inline constexpr const char* kUnitSphere = "length(p) - 1.0";

inline render::SceneJob scene_job(std::string source, uint32_t size = 64) {
  render::SceneJob job;
  job.source = std::move(source);
  job.state.lights = {scene::DirectionalLight{{0, 0, -1}, {1, 1, 1}}};
  job.state.camera = {.position = {0, 0, 4}, .target = {0, 0, 0}};
  job.state.environment = {.background = {0, 0, 0}, .ambient = {0, 0, 0}};
  job.width = size;
  job.height = size;
  return job;
}

/// The picture, or a failed test that says why there is none.
inline render::ScenePicture expect_scene(render::RenderWorker& worker, const render::SceneJob& job) {
  auto result = draw_scene(worker, job, [](uint64_t, uint64_t) { return true; });
  if (const auto* fault = std::get_if<render::RenderFault>(&result)) {
    ADD_FAILURE() << fault->message;
    return {job.width, job.height};
  }
  return std::get<render::ScenePicture>(std::move(result));
}

inline render::Picture expect_scene_picture(render::RenderWorker& worker, const render::SceneJob& job,
                                            const render::SceneDisplay& display = {}) {
  return expect_scene(worker, job).picture(job.look.view, display);
}

}  // namespace texbrdf::test
