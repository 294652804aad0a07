#pragma once

#include <vector>

#include "eval/evaluate.h"

namespace texbrdf::features {

/// Directions for which two computations of one thing are compared, in the tangent frame: far from each other and from
/// what is special.
const std::vector<eval::Geometry>& sample_geometries();

}  // namespace texbrdf::features
