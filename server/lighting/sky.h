#pragma once

#include <optional>
#include <string>

#include "lighting/environment.h"

namespace texbrdf::lighting {

/// A clear sky by day. Angles in degrees.
struct Sky {
  double elevation = 45;  ///< of the sun over the horizon, 0 to 90
  double azimuth = -30;   ///< of the sun from +z towards +x: 0 is behind a viewer who looks along -z, 90 at his right
  double turbidity = 3;   ///< 2 (clear) to 10 (hazy): how much haze scatters beside the air itself
  friend bool operator==(const Sky&, const Sky&) = default;
};

/// Why there is no such sky, in words, or nothing.
std::optional<std::string> find_fault(const Sky& sky);

/// The light of the sky without the sun's disc (A. J. Preetham, P. Shirley, B. Smits, A Practical Analytic Model for
/// Daylight, SIGGRAPH 1999, appendix A.2). Scaled so that level ground receives the irradiance π, as in a furnace;
/// the ground below reflects a fifth of it. The sky has no fault.
EnvironmentMap make_sky(const Sky& sky);

}  // namespace texbrdf::lighting
