#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "eval/evaluate.h"
#include "plots/request.h"
#include "preview/exact_model.h"

namespace texbrdf::plots {

/// A value of the BRDF, raw, or nothing where a direction lies below the surface. A real is there three times.
using Sample = std::optional<eval::Triple>;

/// Values over one angle.
struct Curve {
  std::vector<double> angles;  ///< degrees, ascending
  std::vector<Sample> values;  ///< by angle
  /// By angle, of the albedo only: how far each value may be off, as far as the quadrature can tell.
  std::vector<eval::Triple> errors;
  std::string problem;  ///< why there are no values; one line for a person
};

/// Values over two angles.
struct Grid {
  std::vector<double> rows;     ///< degrees, ascending: theta of the viewer, theta_d
  std::vector<double> columns;  ///< degrees, ascending: phi of the viewer, theta_h
  std::vector<Sample> values;   ///< row by row
  std::string problem;
};

/// How finely a BRDF is asked. What it costs is known beforehand: where the steps of the evaluator (over all samples
/// together) do not suffice, samples are fewer, and where they are too few for any, there is a problem.
struct Effort {
  uint64_t steps = 0;
  int refinements = 0;  ///< how often an interval of a curve is halved where the curve bends
};

inline constexpr std::string_view kTooSlow = "the BRDF is too slow to be plotted";

/// Whether values of the view are over two angles.
bool has_grid(View view);

/// Polar, theta-o: from -90 to 90, positive on the side away from the light. Theta-h, theta-d: from 0 to 90. The
/// albedo: albedo.h.
Curve sample_curve(const preview::ExactModel& model, const Request& request, const Effort& effort);
/// A lobe: the viewer over the hemisphere, narrower near the mirrored light; the first and the last column are a turn
/// apart. A slice: the middles of cells of equal width from 0 to 90.
Grid sample_grid(const preview::ExactModel& model, const Request& request, const Effort& effort);

/// What the view asks of the model at a viewer's angles, or at a half vector's and a difference angle.
eval::Geometry geometry_in_plane(const Request& request, double theta_o);
eval::Geometry geometry_of_viewer(const Request& request, double theta_o, double phi_o);

}  // namespace texbrdf::plots
