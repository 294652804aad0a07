#pragma once

#include <array>
#include <vector>

namespace texbrdf::render {

/// Geometries as fifteen lists of the same length: L, V, N, X, Y by component.
using GeometryTable = std::array<std::vector<float>, 15>;

}  // namespace texbrdf::render
