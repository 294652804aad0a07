#pragma once

#include "scene/scene.h"

namespace texbrdf::viewing {

// Cameras that are moved by hand. All keep `up` and the field of view; what is not finite moves nothing.

/// Turns the camera around its target, by radians: `right` brings it to the right of where it was, `above` raises it,
/// but never so far that it looks along `up`.
scene::Camera orbit(const scene::Camera& camera, double right, double above);

/// Each notch brings the camera a tenth of the way to its target; negative ones lead away.
scene::Camera dolly(const scene::Camera& camera, double notches);

/// In the directions of the picture, each −1 to 1.
struct Walk {
  double right = 0;
  double up = 0;
  double forward = 0;
  friend bool operator==(const Walk&, const Walk&) = default;
};

/// Moves camera and target, each second by the distance between them.
scene::Camera walk(const scene::Camera& camera, const Walk& direction, double seconds);

}  // namespace texbrdf::viewing
