#pragma once

#include <string>

#include "plots/plot.h"

namespace texbrdf::plots {

/// A row for each sample: which series, the angles in degrees, the numbers that the plot shows and, of the albedo, how
/// far each may be off. Numbers read back as the same doubles; one that is none is `nan` or `inf`, and where a
/// direction is below the horizon the cells are empty. The look's scale makes no difference.
std::string write_csv(const Plot& plot);

}  // namespace texbrdf::plots
