#include "objects/teapot.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

namespace texbrdf::objects {

namespace {

/// Control points by row and place in it: u goes along a row, v from row to row. Normals are ∂v × ∂u.
using Patch = std::array<std::array<glm::dvec3, 4>, 4>;

struct TurnedRow {
  double radius;
  double handle;
  double height;
};

struct TubeRow {
  double x0;
  double z0;
  double x1;
  double z1;
  double width;
};

constexpr auto kTurnedRows = std::to_array<TurnedRow>({
#define TEAPOT_TURNED(radius, handle, height) {radius, handle, height},
#include "objects/teapot.def"
});

constexpr auto kTubeRows = std::to_array<TubeRow>({
#define TEAPOT_TUBE(x0, z0, x1, z1, width) {x0, z0, x1, z1, width},
#include "objects/teapot.def"
});

/// Newell's +z is up here: (x, y, z) becomes (x, z, -y).
glm::dvec3 upright(double x, double y, double z) {
  return {x, z, -y};
}

/// The row turned by `quarter` quarters of a turn, counter-clockwise seen from above.
std::array<glm::dvec3, 4> points_of(const TurnedRow& row, int quarter) {
  std::array<std::pair<double, double>, 4> points{
      {{row.radius, 0}, {row.radius, row.handle}, {row.handle, row.radius}, {0, row.radius}}};
  for (auto& [x, y] : points) {
    for (int turn = 0; turn < quarter; ++turn) x = std::exchange(y, x) * -1;
  }
  std::array<glm::dvec3, 4> row_points;
  for (std::size_t i = 0; i < 4; ++i) row_points[i] = upright(points[i].first, points[i].second, row.height);
  return row_points;
}

/// `side` is -1 or 1: the half of the cross-section at negative or positive y. Both are run through so that they go the
/// same way around.
std::array<glm::dvec3, 4> points_of(const TubeRow& row, int side) {
  const double y = row.width * side;
  std::array<glm::dvec3, 4> points{upright(row.x0, 0, row.z0), upright(row.x0, y, row.z0), upright(row.x1, y, row.z1),
                                   upright(row.x1, 0, row.z1)};
  if (side < 0) std::ranges::reverse(points);
  return points;
}

template <typename Rows>
Patch patch_of(const Rows& rows, std::size_t first, int part) {
  Patch patch;
  for (std::size_t i = 0; i < 4; ++i) patch[i] = points_of(rows[first + i], part);
  return patch;
}

std::array<double, 4> bernstein(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * t * s * s, 3 * t * t * s, t * t * t};
}

std::array<double, 4> bernstein_slopes(double t) {
  const double s = 1 - t;
  return {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
}

glm::dvec3 blend(const Patch& patch, const std::array<double, 4>& along_v, const std::array<double, 4>& along_u) {
  glm::dvec3 sum(0);
  for (std::size_t v = 0; v < 4; ++v) {
    for (std::size_t u = 0; u < 4; ++u) sum += patch[v][u] * (along_v[v] * along_u[u]);
  }
  return sum;
}

/// At the poles of lid and bottom a row shrinks to a point and has no direction: the frame there is its limit.
constexpr double kPoleDistance = 1e-5;

Vertex vertex_at(const Patch& patch, double u, double v) {
  const glm::dvec3 position = blend(patch, bernstein(v), bernstein(u));
  glm::dvec3 along_u = blend(patch, bernstein(v), bernstein_slopes(u));
  glm::dvec3 along_v = blend(patch, bernstein_slopes(v), bernstein(u));
  if (glm::length(along_u) < kPoleDistance) {
    const double beside = v < 0.5 ? v + kPoleDistance : v - kPoleDistance;
    along_u = blend(patch, bernstein(beside), bernstein_slopes(u));
    along_v = blend(patch, bernstein_slopes(beside), bernstein(u));
  }
  const glm::dvec3 normal = glm::normalize(glm::cross(along_v, along_u));
  return {glm::vec3(position), glm::vec3(normal), glm::vec3(tangent_along(normal, along_u))};
}

void append(Mesh& mesh, const Patch& patch, uint32_t steps) {
  const auto first = static_cast<uint32_t>(mesh.vertices.size());
  const uint32_t row = steps + 1;
  for (uint32_t v = 0; v <= steps; ++v) {
    for (uint32_t u = 0; u <= steps; ++u) {
      mesh.vertices.push_back(vertex_at(patch, static_cast<double>(u) / steps, static_cast<double>(v) / steps));
    }
  }
  for (uint32_t v = 0; v < steps; ++v) {
    for (uint32_t u = 0; u < steps; ++u) {
      const uint32_t corner = first + v * row + u;
      mesh.triangles.push_back({corner, corner + row, corner + row + 1});
      mesh.triangles.push_back({corner, corner + row + 1, corner + 1});
    }
  }
}

}  // namespace

Mesh make_teapot(uint32_t steps) {
  Mesh mesh;
  for (std::size_t first = 0; first < kTurnedRows.size(); first += 4) {
    for (int quarter = 0; quarter < 4; ++quarter) append(mesh, patch_of(kTurnedRows, first, quarter), steps);
  }
  for (std::size_t first = 0; first < kTubeRows.size(); first += 4) {
    for (const int side : {-1, 1}) append(mesh, patch_of(kTubeRows, first, side), steps);
  }
  return mesh;
}

}  // namespace texbrdf::objects
