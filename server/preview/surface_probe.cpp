#include "preview/surface_probe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texbrdf::preview {
namespace {

double dot(const eval::Triple& a, const eval::Triple& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double degrees(double radians) {
  return radians * 180 / std::numbers::pi;
}

Angles angles_of(const eval::Triple& direction, const render::SurfacePoint& point) {
  const double along_normal = std::clamp(dot(direction, point.normal), -1.0, 1.0);
  const double phi = std::atan2(dot(direction, point.bitangent), dot(direction, point.tangent));
  return {degrees(std::acos(along_normal)), degrees(phi)};
}

}  // namespace

std::optional<SurfaceProbe> probe_surface(const render::SphereView& view, render::PicturePlace place) {
  const std::optional<render::SurfacePoint> point = render::surface_point(view, place);
  if (!point) return std::nullopt;
  const eval::Triple light = render::light_direction(view);
  return SurfaceProbe{.geometry = {.light = light,
                                   .view = render::kViewDirection,
                                   .normal = point->normal,
                                   .tangent = point->tangent,
                                   .bitangent = point->bitangent},
                      .light = angles_of(light, *point),
                      .view = angles_of(render::kViewDirection, *point),
                      .is_lit = dot(light, point->normal) > 0};
}

}  // namespace texbrdf::preview
