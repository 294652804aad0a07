#pragma once

#include "plots/samples.h"
#include "render/sphere.h"

namespace texbrdf::plots {

/// What a plot beside the sphere shows: the light stands as it does for the middle of the sphere.
Request request_beside(const render::SphereView& view, View plotted);

/// Why there is no plot of the request, or nothing: a light that is behind the surface is no mistake of the viewer's.
std::optional<std::string> problem_of(const Request& request);

/// Somebody waits: some 10 ms for a curve, some 30 where there are many values.
Effort quick_effort(View plotted);

}  // namespace texbrdf::plots
