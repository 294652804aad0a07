#pragma once

#include "plots/samples.h"

namespace texbrdf::plots {

/// The directional albedo, the integral of f · cos theta_o over all viewers, from 0 to 89 degrees of the light, each
/// with an estimate of its numerical error. What it is NaN for has no number somewhere among the viewers.
/// With the cosine of the request: times cos theta_i, what is reflected of a beam of constant radiance.
Curve sample_albedo(const preview::ExactModel& model, const Request& request, const Effort& effort);

}  // namespace texbrdf::plots
