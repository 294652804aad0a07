#pragma once

#include "plots/drawing.h"
#include "plots/plot.h"

namespace texbrdf::plots {

/// The half vector's angle to the right, the difference angle upwards; a field for each series. Colours of a BRDF as
/// they are, or a single number on a scale of colours that is drawn beside it.
Drawing draw_slice(const Plot& plot);

}  // namespace texbrdf::plots
