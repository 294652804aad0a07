#pragma once

#include <optional>

#include "scene/box.h"
#include "scene/tree_plan.h"

namespace texbrdf::scene {

/// Contains all places of the node's own frame where it and its children say at most `level`, which is not negative.
/// Infinite where that cannot be told: of planes, repetition without end, dynamic children, primitives of users without
/// bounds. Grown by a distance it contains what is at most that much more than `level`.
Box level_box(const TreePlan& plan, uint32_t index, double level);

/// The same of a node in the frame of its parent; all, if it is dynamic.
Box placed_box(const TreePlan& plan, uint32_t index, double level);

/// The same of all children, united, in the frame of the node.
Box children_box(const TreePlan& plan, const PlannedNode& node, double level);

/// How far the box reaches from the origin in the plane of two axes.
double radius_about(const Box& box, int first_axis, int second_axis);

/// Of a twist or bend of bounded children: contains what comes of them, with some room.
std::optional<Box> deformed_box(const TreePlan& plan, const PlannedNode& node);

}  // namespace texbrdf::scene
