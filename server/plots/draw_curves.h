#pragma once

#include "plots/drawing.h"
#include "plots/plot.h"

namespace texbrdf::plots {

/// Values upwards over an angle to the right.
Drawing draw_cartesian(const Plot& plot);
/// Values as distance from the origin, the viewer's angle from the normal.
Drawing draw_polar(const Plot& plot);

}  // namespace texbrdf::plots
