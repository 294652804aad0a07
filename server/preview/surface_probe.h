#pragma once

#include <optional>

#include "eval/evaluate.h"
#include "render/sphere.h"

namespace texbrdf::preview {

/// A direction in the tangent frame of a point: degrees from the normal, and around it from X towards Y.
struct Angles {
  double theta = 0;  ///< 0 to 180
  double phi = 0;    ///< above -180, to 180
};

/// A point of the sphere that a picture shows.
struct SurfaceProbe {
  eval::Geometry geometry;  ///< in the frame of the picture
  Angles light;
  Angles view;
  bool is_lit = false;  ///< the BRDF is asked for nowhere else
};

/// Nothing beside the sphere.
std::optional<SurfaceProbe> probe_surface(const render::SphereView& view, render::PicturePlace place);

}  // namespace texbrdf::preview
