#include "render/sphere.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace texbrdf::render {

namespace {

/// The sphere's radius as a part of the picture's width, not zoomed.
constexpr double kRadius = 0.45;

/// In pixels from the middle of the picture.
struct Point {
  double x;  ///< right
  double y;  ///< up
};

Point centre_of(const SphereView& view, uint32_t row, uint32_t column) {
  const double middle = view.size / 2.0;
  return {column + 0.5 - middle, middle - row - 0.5};
}

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

std::array<float, 3> in_single_precision(const std::array<double, 3>& vector) {
  return {static_cast<float>(vector[0]), static_cast<float>(vector[1]), static_cast<float>(vector[2])};
}

void append(SphereGeometry::Vectors& vectors, const std::array<double, 3>& vector) {
  for (std::size_t c = 0; c < 3; ++c) vectors[c].push_back(static_cast<float>(vector[c]));
}

void reserve(SphereGeometry& geometry, std::size_t points) {
  geometry.pixels.reserve(points);
  geometry.cosines.reserve(points);
  for (SphereGeometry::Vectors* vectors : {&geometry.normals, &geometry.tangents, &geometry.bitangents}) {
    for (std::vector<float>& coordinates : *vectors) coordinates.reserve(points);
  }
}

/// How far in front of the unit disc the sphere is; 0 on the disc's edge and outside.
double depth(double x, double y) {
  return std::sqrt(std::max(0.0, 1 - x * x - y * y));
}

/// X = normalize((0,1,0) × N) = (N.z, 0, -N.x) / |…|, Y = N × X. Where N is parallel to (0,1,0), X is (1,0,0): the
/// limit from the visible side.
SurfacePoint surface_at(double x, double y, double z) {
  const double length = std::sqrt(x * x + z * z);
  const double tangent_x = length > 0 ? z / length : 1;
  const double tangent_z = length > 0 ? -x / length : 0;
  return {.normal = {x, y, z},
          .tangent = {tangent_x, 0, tangent_z},
          .bitangent = {y * tangent_z, z * tangent_x - x * tangent_z, -y * tangent_x}};
}

void append(SphereGeometry& geometry, const SurfacePoint& point) {
  append(geometry.normals, point.normal);
  append(geometry.tangents, point.tangent);
  append(geometry.bitangents, point.bitangent);
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

double sphere_radius(const SphereView& view) {
  return kRadius * view.size * view.zoom;
}

bool same_geometry(const SphereView& a, const SphereView& b) {
  return a.size == b.size && a.theta == b.theta && a.phi == b.phi && a.zoom == b.zoom;
}

std::array<double, 3> light_direction(const SphereView& view) {
  const double theta = view.theta * std::numbers::pi / 180;
  const double phi = view.phi * std::numbers::pi / 180;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

std::optional<SurfacePoint> surface_point(const SphereView& view, PicturePlace place) {
  const double x = (place.x - 0.5) / (kRadius * view.zoom);
  const double y = (0.5 - place.y) / (kRadius * view.zoom);
  const double z = depth(x, y);
  if (!(z > 0)) return std::nullopt;
  return surface_at(x, y, z);
}

PicturePlace sample_place(const SphereView& view, uint32_t pixel) {
  const Point centre = centre_of(view, pixel / view.size, pixel % view.size);
  const Point sampled = sample_of(centre, sphere_radius(view)).point;
  return {0.5 + sampled.x / view.size, 0.5 - sampled.y / view.size};
}

SphereGeometry make_sphere_geometry(const SphereView& view, SpherePoints points) {
  SphereGeometry geometry;
  geometry.size = view.size;
  geometry.light = in_single_precision(light_direction(view));
  geometry.alpha.assign(std::size_t{view.size} * view.size, 0);
  reserve(geometry, geometry.alpha.size());
  const auto& [light_x, light_y, light_z] = geometry.light;
  const double radius = sphere_radius(view);
  for (uint32_t row = 0; row < view.size; ++row) {
    for (uint32_t column = 0; column < view.size; ++column) {
      const uint32_t pixel = row * view.size + column;
      const Sample sample = sample_of(centre_of(view, row, column), radius);
      geometry.alpha[pixel] = alpha_of(sample.coverage);
      if (geometry.alpha[pixel] == 0) continue;
      const double x = sample.point.x / radius;
      const double y = sample.point.y / radius;
      const double z = depth(x, y);
      const double cosine = x * light_x + y * light_y + z * light_z;
      if ((cosine <= 0 && points == SpherePoints::Lit) || z <= 0) continue;
      geometry.pixels.push_back(pixel);
      geometry.cosines.push_back(static_cast<float>(cosine));
      append(geometry, surface_at(x, y, z));
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
