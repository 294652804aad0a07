#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "preview/exact_model.h"
#include "render/sphere.h"

namespace texbrdf::preview {

/// Values of a BRDF in the plane of incidence, with the light where it stands for the middle of the sphere.
struct Plot {
  double light_theta = 0;            ///< degrees from the normal, 0 to 180
  std::vector<double> angles;        ///< degrees of the viewer, positive on the side away from the light
  std::vector<eval::Triple> values;  ///< by angle
  std::string problem;               ///< why there are no values; one line for a person
};

/// From -90 to 90 degrees in steps of a half, or in wider ones where a BRDF is too slow for that. With N·V in the
/// values where the view has N·L.
Plot plot(const ExactModel& model, const render::SphereView& view);
/// A plot without values.
Plot empty_plot(const render::SphereView& view, std::string problem);

}  // namespace texbrdf::preview
