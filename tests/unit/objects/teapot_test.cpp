#include "objects/teapot.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <set>

namespace texbrdf::objects {
namespace {

using Place = std::array<long, 3>;

Place rounded(const glm::vec3& place) {
  return {std::lround(place.x * 1e4F), std::lround(place.y * 1e4F), std::lround(place.z * 1e4F)};
}

/// Vertices of different patches in one place, as one number.
class Joined {
 public:
  explicit Joined(const Mesh& mesh) {
    for (const Vertex& vertex : mesh.vertices) {
      numbers_.push_back(places_.try_emplace(rounded(vertex.position), places_.size()).first->second);
    }
  }
  std::size_t of(uint32_t vertex) const { return numbers_[vertex]; }

 private:
  std::map<Place, std::size_t> places_;
  std::vector<std::size_t> numbers_;
};

using Edge = std::pair<std::size_t, std::size_t>;

/// Of each edge how often triangles run along it, without those that have no area.
std::map<Edge, int> edges_of(const Mesh& mesh) {
  const Joined joined(mesh);
  std::map<Edge, int> edges;
  for (const Triangle& triangle : mesh.triangles) {
    const std::array<std::size_t, 3> corners{joined.of(triangle[0]), joined.of(triangle[1]), joined.of(triangle[2])};
    if (std::set(corners.begin(), corners.end()).size() < 3) continue;
    for (std::size_t i = 0; i < 3; ++i) ++edges[{corners[i], corners[(i + 1) % 3]}];
  }
  return edges;
}

TEST(Teapot, NeighboursTurnTheSameWay) {
  for (const auto& [edge, count] : edges_of(make_teapot(6))) EXPECT_EQ(count, 1);
}

/// Open where Newell's is: the inner edge of the rim, the edge of the lid, two ends of the handle and two of the spout.
/// The bottom is closed.
TEST(Teapot, HasSixOpenEdges) {
  const std::map<Edge, int> edges = edges_of(make_teapot(6));
  std::map<std::size_t, std::size_t> next;
  for (const auto& [edge, count] : edges) {
    if (!edges.contains({edge.second, edge.first})) {
      EXPECT_TRUE(next.emplace(edge.first, edge.second).second);
    }
  }
  int loops = 0;
  for (; !next.empty(); ++loops) {
    for (auto at = next.begin(); at != next.end();) {
      const std::size_t following = at->second;
      next.erase(at);
      at = next.find(following);
    }
  }
  EXPECT_EQ(loops, 6);
}

TEST(Teapot, NormalsAndTangentsAreUnitAndAtRightAngles) {
  for (const Vertex& vertex : make_teapot(9).vertices) {
    EXPECT_NEAR(glm::length(vertex.normal), 1, 1e-5);
    EXPECT_NEAR(glm::length(vertex.tangent), 1, 1e-5);
    EXPECT_NEAR(glm::dot(vertex.normal, vertex.tangent), 0, 1e-5);
  }
}

TEST(Teapot, NormalsAreOnTheSideOfTheirTriangles) {
  const Mesh mesh = make_teapot();
  for (const Triangle& triangle : mesh.triangles) {
    const auto& [a, b, c] = triangle;
    const glm::dvec3 first(mesh.vertices[a].position);
    const glm::dvec3 face =
        glm::cross(glm::dvec3(mesh.vertices[b].position) - first, glm::dvec3(mesh.vertices[c].position) - first);
    if (glm::length(face) < 1e-9) continue;
    for (const uint32_t corner : triangle) {
      EXPECT_GT(glm::dot(glm::normalize(face), glm::dvec3(mesh.vertices[corner].normal)), 0);
    }
  }
}

/// Far from the axis, and on top and bottom, outside is away from the middle.
TEST(Teapot, NormalsPointOutwards) {
  for (const Vertex& vertex : make_teapot().vertices) {
    const glm::vec3& place = vertex.position;
    if (place.y < 0.01F) {
      EXPECT_LT(vertex.normal.y, 0);
    }
    if (place.y > 3.14F) {
      EXPECT_GT(vertex.normal.y, 0);
    }
    if (std::abs(place.z) > 1.6F) {
      EXPECT_GT(place.z * vertex.normal.z, 0);
    }
    if (place.x < -2.95F) {
      EXPECT_LT(vertex.normal.x, 0);
    }
  }
}

TEST(Teapot, HasTheSizeOfNewells) {
  glm::vec3 low(1e9F);
  glm::vec3 high(-1e9F);
  for (const Vertex& vertex : make_teapot().vertices) {
    low = glm::min(low, vertex.position);
    high = glm::max(high, vertex.position);
  }
  EXPECT_NEAR(low.x, -3, 0.01);
  EXPECT_NEAR(high.x, 3.434, 0.01);  // the lip of the spout, within its control points
  EXPECT_NEAR(low.y, 0, 1e-5);
  EXPECT_NEAR(high.y, 3.15, 1e-5);
  EXPECT_NEAR(high.z, 2, 0.001);
  EXPECT_NEAR(low.z, -2, 0.001);
}

TEST(Teapot, FitsIntoTheUnitSphere) {
  Mesh mesh = make_teapot();
  fit_into_unit_sphere(mesh);
  float farthest = 0;
  for (const Vertex& vertex : mesh.vertices) farthest = std::max(farthest, glm::length(vertex.position));
  EXPECT_NEAR(farthest, 1, 1e-5);
}

}  // namespace
}  // namespace texbrdf::objects
