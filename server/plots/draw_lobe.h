#pragma once

#include "plots/drawing.h"
#include "plots/plot.h"

namespace texbrdf::plots {

/// The surface of all f · omega_o above the plane of the surface, seen from afar in parallel, what is nearer before
/// what is behind it.
Drawing draw_lobe(const Plot& plot);

}  // namespace texbrdf::plots
