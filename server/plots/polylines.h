#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "plots/channels.h"
#include "plots/drawing.h"
#include "plots/scale.h"

namespace texbrdf::plots {

/// Where an angle and a part of the axis of values, 0 to 1, are on the picture.
using Placement = std::function<Point(double angle, double fraction)>;

/// The lines through the values of a curve: a gap where there is none, cut off at the ends of the axis. One that stands
/// alone is a line of no length.
std::vector<std::vector<Point>> lines_through(const Curve& curve, const Component& component, const Scale& scale,
                                              const Placement& placement);

}  // namespace texbrdf::plots
