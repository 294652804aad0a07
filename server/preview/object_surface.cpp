#include "preview/object_surface.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace texbrdf::preview {

namespace {

/// Rounded coordinates of a point near the silhouette still give a point that is seen.
constexpr double kLeastDepth = 1e-4;

objects::Coverage sphere_coverage(const render::SphereView& view) {
  render::SphereGeometry sphere = make_sphere_geometry(view, render::SpherePoints::All);
  objects::Coverage coverage{view.size, std::move(sphere.alpha), {0}, {}};
  coverage.begins.reserve(coverage.alpha.size() + 1);
  std::size_t point = 0;
  for (std::size_t pixel = 0; pixel < coverage.alpha.size(); ++pixel) {
    if (point < sphere.point_count() && sphere.pixels[point] == pixel) {
      coverage.fragments.push_back({0, sphere.normals[0][point], sphere.normals[1][point]});
      ++point;
    }
    coverage.begins.push_back(static_cast<uint32_t>(coverage.fragments.size()));
  }
  return coverage;
}

glm::dvec3 sphere_normal(const objects::Fragment& fragment) {
  const double x = fragment.second;
  const double y = fragment.third;
  const double z = std::sqrt(std::max(1 - x * x - y * y, kLeastDepth * kLeastDepth));
  return glm::dvec3(x, y, z) / std::sqrt(x * x + y * y + z * z);
}

}  // namespace

ObjectSurface::ObjectSurface(SeenObject object, const render::SphereView& view)
    : object_(std::move(object)),
      rotation_(objects::rotation_of(object_.orbit)),
      coverage_(object_.mesh ? objects::rasterise(*object_.mesh, rotation_, view.size, render::sphere_radius(view))
                             : sphere_coverage(view)) {}

objects::SurfaceFrame ObjectSurface::frame(std::size_t fragment) const {
  const objects::Fragment& at = coverage_.fragments[fragment];
  if (object_.mesh) return objects::frame_at(*object_.mesh, rotation_, at);
  return objects::frame_of_normal(rotation_, sphere_normal(at));
}

}  // namespace texbrdf::preview
