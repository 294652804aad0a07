#include "render/sphere.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texbrdf::render {

namespace {

/// The sphere's radius as a part of the picture's width, not zoomed.
constexpr double kRadius = 0.45;

struct Point {
  double x;  ///< right
  double y;  ///< up
};

/// What of a pixel the sphere covers, by the distance of its centre from the edge, and where it is sampled: a pixel
/// that the edge crosses in the middle of what is covered, so that no sample lies on the silhouette itself.
struct Sample {
  double coverage = 0;
  Point point{};
};

Sample sample_of(Point centre, double radius) {
  const double distance = std::sqrt(centre.x * centre.x + centre.y * centre.y);
  Sample sample{std::clamp(radius - distance + 0.5, 0.0, 1.0), centre};
  const double middle = radius - sample.coverage / 2;
  if (sample.coverage < 1 && distance > 0) {
    sample.point = {centre.x * middle / distance, centre.y * middle / distance};
  }
  return sample;
}

uint8_t alpha_of(double coverage) {
  if (coverage <= 0) return 0;
  if (coverage >= 1) return 255;
  return static_cast<uint8_t>(std::lround(coverage * 255));
}

std::array<float, 3> direction(double theta_degrees, double phi_degrees) {
  const double theta = theta_degrees * std::numbers::pi / 180;
  const double phi = phi_degrees * std::numbers::pi / 180;
  return {static_cast<float>(std::sin(theta) * std::cos(phi)), static_cast<float>(std::sin(theta) * std::sin(phi)),
          static_cast<float>(std::cos(theta))};
}

void append(SphereGeometry::Vectors& vectors, double x, double y, double z) {
  vectors[0].push_back(static_cast<float>(x));
  vectors[1].push_back(static_cast<float>(y));
  vectors[2].push_back(static_cast<float>(z));
}

void reserve(SphereGeometry& geometry, std::size_t points) {
  geometry.pixels.reserve(points);
  geometry.cosines.reserve(points);
  for (SphereGeometry::Vectors* vectors : {&geometry.normals, &geometry.tangents, &geometry.bitangents}) {
    for (std::vector<float>& coordinates : *vectors) coordinates.reserve(points);
  }
}

/// X = normalize((0,1,0) × N) = (N.z, 0, -N.x) / |…|, Y = N × X. Where N is parallel to (0,1,0), X is (1,0,0): the
/// limit from the visible side.
void append_frame(SphereGeometry& geometry, double x, double y, double z) {
  const double length = std::sqrt(x * x + z * z);
  const double tangent_x = length > 0 ? z / length : 1;
  const double tangent_z = length > 0 ? -x / length : 0;
  append(geometry.normals, x, y, z);
  append(geometry.tangents, tangent_x, 0, tangent_z);
  append(geometry.bitangents, y * tangent_z, z * tangent_x - x * tangent_z, -y * tangent_x);
}

}  // namespace

std::optional<std::string> find_fault(const SphereView& view) {
  if (view.size < 1 || view.size > kMaxPictureSize) {
    return fmt::format("the size of a picture is 1 to {} pixels, not {}", kMaxPictureSize, view.size);
  }
  if (!std::isfinite(view.theta) || !std::isfinite(view.phi)) return "theta and phi are angles in degrees";
  if (!(view.gamma >= 0.1 && view.gamma <= 10)) return fmt::format("gamma is 0.1 to 10, not {}", view.gamma);
  if (!(std::abs(view.exposure) <= 60)) return fmt::format("exposure is -60 to 60, not {}", view.exposure);
  if (!(view.zoom >= 0.1 && view.zoom <= 100)) return fmt::format("zoom is 0.1 to 100, not {}", view.zoom);
  return std::nullopt;
}

bool same_geometry(const SphereView& a, const SphereView& b) {
  return a.size == b.size && a.theta == b.theta && a.phi == b.phi && a.zoom == b.zoom;
}

SphereGeometry make_sphere_geometry(const SphereView& view) {
  SphereGeometry geometry;
  geometry.size = view.size;
  geometry.light = direction(view.theta, view.phi);
  geometry.alpha.assign(std::size_t{view.size} * view.size, 0);
  reserve(geometry, geometry.alpha.size());
  const auto& [light_x, light_y, light_z] = geometry.light;
  const double middle = view.size / 2.0;
  const double radius = kRadius * view.size * view.zoom;
  for (uint32_t row = 0; row < view.size; ++row) {
    for (uint32_t column = 0; column < view.size; ++column) {
      const uint32_t pixel = row * view.size + column;
      const Sample sample = sample_of({column + 0.5 - middle, middle - row - 0.5}, radius);
      geometry.alpha[pixel] = alpha_of(sample.coverage);
      if (geometry.alpha[pixel] == 0) continue;
      const double x = sample.point.x / radius;
      const double y = sample.point.y / radius;
      const double z = std::sqrt(std::max(0.0, 1 - x * x - y * y));
      const double cosine = x * light_x + y * light_y + z * light_z;
      if (cosine <= 0 || z <= 0) continue;
      geometry.pixels.push_back(pixel);
      geometry.cosines.push_back(static_cast<float>(cosine));
      append_frame(geometry, x, y, z);
    }
  }
  return geometry;
}

const SphereGeometry& SphereCache::geometry(const SphereView& view) {
  if (!view_ || !same_geometry(*view_, view)) geometry_ = make_sphere_geometry(view);
  view_ = view;
  return geometry_;
}

}  // namespace texbrdf::render
