#include "plots/directions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texbrdf::plots {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
/// What rounding makes of a direction in the surface.
constexpr double kHorizonTolerance = 1e-12;

double dot(const eval::Triple& a, const eval::Triple& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

eval::Triple about_z(const eval::Triple& v, double degrees) {
  const double c = cosine_of(degrees);
  const double s = sine_of(degrees);
  return {c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
}

/// Takes z to x at 90 degrees.
eval::Triple about_y(const eval::Triple& v, double degrees) {
  const double c = cosine_of(degrees);
  const double s = sine_of(degrees);
  return {c * v[0] + s * v[2], v[1], c * v[2] - s * v[0]};
}

eval::Triple towards_surface(const eval::Triple& v) {
  const bool is_rounding = std::abs(v[2]) < kHorizonTolerance;
  return is_rounding ? eval::Triple{v[0], v[1], 0} : v;
}

}  // namespace

double sine_of(double degrees) {
  const double turned = std::remainder(degrees, 360);  // exact, as all up to the sine
  const double folded = std::abs(turned) > 90 ? std::copysign(180, turned) - turned : turned;
  if (std::abs(folded) == 90) return folded / 90;
  return std::sin(folded * kRadians);
}

double cosine_of(double degrees) {
  return sine_of(90 - std::abs(std::remainder(degrees, 360)));
}

eval::Triple direction(double theta, double phi) {
  const double s = sine_of(theta);
  return {s * cosine_of(phi), s * sine_of(phi), cosine_of(theta)};
}

eval::Geometry geometry_of(const HalfAngles& angles) {
  const eval::Triple light = direction(angles.theta_d, angles.phi_d);
  const eval::Triple view = {-light[0], -light[1], light[2]};
  const auto placed = [&](const eval::Triple& v) {
    return towards_surface(about_z(about_y(v, angles.theta_h), angles.phi_h));
  };
  return {.light = placed(light), .view = placed(view)};
}

bool is_above_horizon(const eval::Geometry& geometry) {
  return std::min(dot(geometry.light, geometry.normal), dot(geometry.view, geometry.normal)) >= 0;
}

}  // namespace texbrdf::plots
