#pragma once

#include "eval/evaluate.h"

namespace texbrdf::plots {

/// Of degrees; exact at multiples of 90, so that the horizon is where a cosine is 0.
double sine_of(double degrees);
double cosine_of(double degrees);

/// In the frame of the surface (z is the normal): `theta` degrees from the normal, `phi` around it from x towards y.
eval::Triple direction(double theta, double phi);

/// A pair of directions by the half vector between them and how they lie about it (S. Rusinkiewicz, "A New Change of
/// Variables for Efficient BRDF Representation", 1998). Degrees.
struct HalfAngles {
  double theta_h = 0;
  double phi_h = 0;
  double theta_d = 0;
  double phi_d = 0;
};

eval::Geometry geometry_of(const HalfAngles& angles);

/// Where a BRDF means something: neither direction is below the surface. Rounding is no reason to be below it.
bool is_above_horizon(const eval::Geometry& geometry);

}  // namespace texbrdf::plots
