#include "objects/rasterise.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <numbers>
#include <optional>
#include <tuple>

namespace texbrdf::objects {

namespace {

/// The rays in parts of a pixel, a turned square: edges near a row or a column have all four levels.
constexpr std::array<glm::dvec2, kRays> kRayPlaces{{{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}}};

/// Rows that are drawn together, so that a large picture needs no depth for all of its rays at once.
constexpr std::size_t kBandRays = std::size_t{1} << 20;

struct RayHit {
  float depth = -std::numeric_limits<float>::infinity();  ///< towards the viewer
  Fragment fragment;
};

/// Rows first to last - 1 of the picture.
struct Band {
  uint32_t first;
  uint32_t last;
};

/// A triangle in pixels from the top left, its third coordinate towards the viewer.
struct Projected {
  std::array<glm::dvec3, 3> corners;
  double twice_area;
};

double cross(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

std::vector<glm::vec3> project(const Mesh& mesh, const glm::dmat3& rotation, uint32_t size, double scale) {
  std::vector<glm::vec3> projected;
  projected.reserve(mesh.vertices.size());
  for (const Vertex& vertex : mesh.vertices) {
    const glm::dvec3 seen = rotation * glm::dvec3(vertex.position) * scale;
    projected.emplace_back(seen.x + size / 2.0, size / 2.0 - seen.y, seen.z);
  }
  return projected;
}

std::optional<Projected> project(const std::vector<glm::vec3>& places, const Triangle& triangle) {
  Projected projected;
  for (std::size_t i = 0; i < 3; ++i) projected.corners[i] = glm::dvec3(places[triangle[i]]);
  const auto& [a, b, c] = projected.corners;
  projected.twice_area = cross(glm::dvec2(b) - glm::dvec2(a), glm::dvec2(c) - glm::dvec2(a));
  return projected.twice_area == 0 ? std::nullopt : std::optional(projected);
}

/// The pixels from `low` to `high`, cut off at `begin` and `end`.
struct PixelRange {
  uint32_t begin;
  uint32_t end;
};

PixelRange pixels_between(double low, double high, uint32_t begin, uint32_t end) {
  const auto first = std::clamp<double>(std::floor(low), begin, end);
  const auto last = std::clamp<double>(std::floor(high) + 1, begin, end);
  return {static_cast<uint32_t>(first), static_cast<uint32_t>(last)};
}

class BandPainter {
 public:
  BandPainter(uint32_t size, Band band)
      : size_(size), band_(band), hits_(std::size_t{band.last - band.first} * size * kRays) {}

  void draw(const Projected& triangle, uint32_t number) {
    const auto& [a, b, c] = triangle.corners;
    const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    const PixelRange rows = pixels_between(top, bottom, band_.first, band_.last);
    const PixelRange columns = pixels_between(left, right, 0, size_);
    for (uint32_t row = rows.begin; row < rows.end; ++row) {
      for (uint32_t column = columns.begin; column < columns.end; ++column) {
        for (std::size_t ray = 0; ray < kRays; ++ray) draw_ray(triangle, number, row, column, ray);
      }
    }
  }

  void append_to(Coverage& coverage) const {
    for (std::size_t pixel = 0; pixel < hits_.size() / kRays; ++pixel) {
      for (std::size_t ray = 0; ray < kRays; ++ray) {
        const RayHit& hit = hits_[pixel * kRays + ray];
        if (!std::isinf(hit.depth)) coverage.fragments.push_back(hit.fragment);
      }
      const auto count = coverage.fragments.size() - coverage.begins.back();
      coverage.begins.push_back(static_cast<uint32_t>(coverage.fragments.size()));
      coverage.alpha.push_back(static_cast<uint8_t>((count * 255 + kRays / 2) / kRays));
    }
  }

 private:
  void draw_ray(const Projected& triangle, uint32_t number, uint32_t row, uint32_t column, std::size_t ray) {
    const auto& [a, b, c] = triangle.corners;
    const glm::dvec2 place(column + kRayPlaces[ray].x, row + kRayPlaces[ray].y);
    const double first = cross(glm::dvec2(c) - glm::dvec2(b), place - glm::dvec2(b)) / triangle.twice_area;
    const double second = cross(glm::dvec2(a) - glm::dvec2(c), place - glm::dvec2(c)) / triangle.twice_area;
    const double third = cross(glm::dvec2(b) - glm::dvec2(a), place - glm::dvec2(a)) / triangle.twice_area;
    if (!(first >= 0 && second >= 0 && third >= 0)) return;
    const auto depth = static_cast<float>(first * a.z + second * b.z + third * c.z);
    RayHit& hit = hits_[(std::size_t{row - band_.first} * size_ + column) * kRays + ray];
    if (depth <= hit.depth) return;
    hit = {depth, {number, static_cast<float>(second), static_cast<float>(third)}};
  }

  uint32_t size_;
  Band band_;
  std::vector<RayHit> hits_;
};

glm::dvec3 interpolate(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const Fragment& fragment) {
  const double second = fragment.second;
  const double third = fragment.third;
  return glm::dvec3(a) * (1 - second - third) + glm::dvec3(b) * second + glm::dvec3(c) * third;
}

glm::dvec3 unit_or(const glm::dvec3& vector, const glm::dvec3& otherwise) {
  const double length = glm::length(vector);
  return length > 0 ? vector / length : otherwise;
}

/// Towards the viewer (0, 0, 1), although interpolation may have turned it a little away.
glm::dvec3 bend_to_viewer(const glm::dvec3& normal) {
  if (normal.z >= kLeastCosine) return normal;
  const glm::dvec2 across(normal.x, normal.y);
  const double length = glm::length(across);
  if (!(length > 0)) return {0, 0, 1};
  const glm::dvec2 rest = across * (std::sqrt(1 - kLeastCosine * kLeastCosine) / length);
  return {rest.x, rest.y, kLeastCosine};
}

SurfaceFrame frame_from(const glm::dmat3& rotation, const glm::dvec3& normal, const glm::dvec3& wish) {
  const glm::dvec3 tangent = rotation * tangent_along(glm::transpose(rotation) * normal, wish);
  return {normal, tangent, glm::cross(normal, tangent)};
}

}  // namespace

glm::dmat3 rotation_of(const Orbit& orbit) {
  const double yaw = orbit.yaw * std::numbers::pi / 180;
  const double pitch = orbit.pitch * std::numbers::pi / 180;
  // By columns: what becomes of the object's x, y and z axis.
  const glm::dmat3 turn(std::cos(yaw), 0, -std::sin(yaw), 0, 1, 0, std::sin(yaw), 0, std::cos(yaw));
  const glm::dmat3 tip(1, 0, 0, 0, std::cos(pitch), std::sin(pitch), 0, -std::sin(pitch), std::cos(pitch));
  return tip * turn;
}

Coverage rasterise(const Mesh& mesh, const glm::dmat3& rotation, uint32_t size, double scale) {
  const std::vector<glm::vec3> places = project(mesh, rotation, size, scale);
  Coverage coverage{size, {}, {0}, {}};
  const auto band_rows = static_cast<uint32_t>(std::max<std::size_t>(1, kBandRays / kRays / size));
  for (uint32_t row = 0; row < size; row += band_rows) {
    BandPainter painter(size, {row, std::min(size, row + band_rows)});
    for (uint32_t number = 0; number < mesh.triangles.size(); ++number) {
      if (const auto triangle = project(places, mesh.triangles[number])) painter.draw(*triangle, number);
    }
    painter.append_to(coverage);
  }
  return coverage;
}

SurfaceFrame frame_at(const Mesh& mesh, const glm::dmat3& rotation, const Fragment& fragment) {
  const Triangle& triangle = mesh.triangles[fragment.triangle];
  const auto& [a, b, c] = std::tie(mesh.vertices[triangle[0]], mesh.vertices[triangle[1]], mesh.vertices[triangle[2]]);
  const glm::dvec3 face =
      glm::cross(glm::dvec3(b.position) - glm::dvec3(a.position), glm::dvec3(c.position) - glm::dvec3(a.position));
  const glm::dvec3 mixed = interpolate(a.normal, b.normal, c.normal, fragment);
  glm::dvec3 normal = unit_or(mixed, unit_or(face, glm::transpose(rotation) * glm::dvec3(0, 0, 1)));
  const bool agrees = glm::dot(normal, face) >= 0;
  const bool is_front = ((rotation * face).z >= 0) == agrees;
  if (!is_front) normal = -normal;
  return frame_from(rotation, bend_to_viewer(rotation * normal),
                    interpolate(a.tangent, b.tangent, c.tangent, fragment));
}

SurfaceFrame frame_of_normal(const glm::dmat3& rotation, const glm::dvec3& normal) {
  return frame_from(rotation, normal, glm::dvec3(0));
}

}  // namespace texbrdf::objects
