#pragma once

#include <optional>
#include <string_view>

#include "semantics/conventions.h"

namespace texbrdf {

/// The polar angle or azimuth of a direction whose name the angle's name bears: `\theta_m`, `\phi_{\vec{m}}`; a bare
/// `\theta` is that of `\omega`, or of the only direction.
struct ImpliedAngle {
  Convention kind = Convention::ThetaI;  ///< ThetaI or PhiI: how the angle is made of its direction
  std::string_view label;                ///< what the direction is called without decoration: "m", empty for `\omega`
};

/// What the name is the angle of, where it is spelled like one. By canonical forms.
std::optional<ImpliedAngle> implied_angle(std::string_view name);
/// "m" of `m`, `\vec{m}`, `\omega_m` and `\vec{\omega_m}`.
std::string_view direction_label(std::string_view name);

}  // namespace texbrdf
