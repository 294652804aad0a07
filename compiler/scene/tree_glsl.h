#pragma once

#include <span>
#include <string>

#include "scene/tree_plan.h"

namespace texbrdf::scene {

/// The floats of `scene_frames` for each dynamic object: four numbers for each row of the matrix to its frame, factor
/// and padding, four for each row of the matrix from its frame to the world.
inline constexpr std::size_t kFramesStride = 7;

/// `vec2 scene_distance(vec3 place)` and all that it calls but the functions of users, which are
/// `float PREFIX NAME(vec3, Primitive3D)`, with the prefixes by UserPrimitiveId.
std::string tree_glsl(const TreePlan& plan, const Scene& scene, std::span<const std::string> primitive_prefixes);

}  // namespace texbrdf::scene
