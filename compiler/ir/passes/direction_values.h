#pragma once

#include "ir/graph.h"

namespace texbrdf::ir {

/// a·b as the cosine of a convention's θ: within [-1, 1], NaN passed on.
ValueId clamped_cosine(Graph& graph, ValueId a, ValueId b);
/// sin θ from cos θ, for θ in [0, π]: √((1−c)(1+c)), which keeps its precision near c = 1 as 1−c² would not.
ValueId sine_of_polar_angle(Graph& graph, ValueId cosine);

/// Cosine and sine of an azimuth.
struct Azimuth {
  ValueId cosine;
  ValueId sine;
};
/// Of atan2(d·Y, d·X). A direction along the normal has no azimuth; atan2(0, 0) is 0 there, so cosine 1 and sine 0.
Azimuth azimuth_of(Graph& graph, ValueId tangent, ValueId bitangent, ValueId direction);

}  // namespace texbrdf::ir
