#pragma once

#include <glm/vec3.hpp>

#include "scene/box.h"
#include "scene/tree_plan.h"

namespace texbrdf::scene {

/// How the copies of a repetition are found from a place: `window` copies along each axis are asked, those whose cells
/// are nearest; of all others the distance to their boxes is told. The value does not jump where the window moves, and
/// its slope stays at most 1. Children that are too large for the copies that are asked (kMaxCopiesAsked), or
/// unbounded, are cut off at the box.
Repetition plan_repetition(const PlannedNode& node, const Box& children, double level);

inline constexpr double kMaxCopiesAsked = 64;

}  // namespace texbrdf::scene
