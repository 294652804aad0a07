#include "objects/obj_content.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

namespace texbrdf::objects {

namespace {

using Corners = std::array<ObjCorner, 3>;

const glm::vec3& position_of(const ObjContent& content, const ObjCorner& corner) {
  return content.positions[static_cast<std::size_t>(corner.position)];
}

glm::dvec3 edge(const ObjContent& content, const ObjCorner& from, const ObjCorner& to) {
  return glm::dvec3(position_of(content, to)) - glm::dvec3(position_of(content, from));
}

glm::dvec3 unit_or_nothing(const glm::dvec3& vector) {
  const double length = glm::length(vector);
  return length > 0 ? vector / length : glm::dvec3(0);
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::acos(std::clamp(glm::dot(unit_or_nothing(a), unit_or_nothing(b)), -1.0, 1.0));
}

/// Of each vertex: the mean normal of the faces around it, weighted by their angles there; not normalised.
std::vector<glm::dvec3> smooth_normals(const ObjContent& content) {
  std::vector<glm::dvec3> sums(content.positions.size(), glm::dvec3(0));
  for (const Corners& corners : content.triangles) {
    const glm::dvec3 face =
        unit_or_nothing(glm::cross(edge(content, corners[0], corners[1]), edge(content, corners[0], corners[2])));
    for (std::size_t i = 0; i < 3; ++i) {
      const ObjCorner& here = corners[i];
      const double angle =
          angle_between(edge(content, here, corners[(i + 1) % 3]), edge(content, here, corners[(i + 2) % 3]));
      sums[static_cast<std::size_t>(here.position)] += face * angle;
    }
  }
  return sums;
}

/// ∂P/∂u of a triangle, as a unit vector; nothing where its texture coordinates have no area.
glm::dvec3 direction_of_u(const ObjContent& content, const Corners& corners) {
  std::array<glm::dvec2, 3> places;
  for (std::size_t i = 0; i < 3; ++i) {
    if (corners[i].texture_place < 0) return glm::dvec3(0);
    places[i] = glm::dvec2(content.texture_places[static_cast<std::size_t>(corners[i].texture_place)]);
  }
  const glm::dvec2 first = places[1] - places[0];
  const glm::dvec2 second = places[2] - places[0];
  const double area = first.x * second.y - first.y * second.x;
  if (area == 0) return glm::dvec3(0);
  const glm::dvec3 along =
      edge(content, corners[0], corners[1]) * second.y - edge(content, corners[0], corners[2]) * first.y;
  return unit_or_nothing(area > 0 ? along : -along);
}

/// A corner of the mesh, and the vertex and texture coordinate that it shares with others.
struct SharedPlace {
  uint64_t key;
  uint32_t corner;
};

std::vector<SharedPlace> shared_places(const ObjContent& content) {
  std::vector<SharedPlace> places;
  places.reserve(content.triangles.size() * 3);
  for (const Corners& corners : content.triangles) {
    for (const ObjCorner& corner : corners) {
      const uint64_t key =
          uint64_t{static_cast<uint32_t>(corner.position)} << 32 | static_cast<uint32_t>(corner.texture_place);
      places.push_back({key, static_cast<uint32_t>(places.size())});
    }
  }
  std::ranges::sort(places, {}, [](const SharedPlace& place) { return std::pair(place.key, place.corner); });
  return places;
}

/// Triangles that share a vertex and its texture coordinate share the mean of their directions of u there, so that none
/// shows. Corners of the mesh stand in the order of the triangles.
void set_tangents(Mesh& mesh, const ObjContent& content) {
  if (content.texture_places.empty()) return;
  std::vector<glm::vec3> directions;
  directions.reserve(content.triangles.size());
  for (const Corners& corners : content.triangles) directions.emplace_back(direction_of_u(content, corners));
  const std::vector<SharedPlace> places = shared_places(content);
  for (std::size_t begin = 0; begin < places.size();) {
    std::size_t end = begin;
    glm::dvec3 sum(0);
    for (; end < places.size() && places[end].key == places[begin].key; ++end) {
      sum += glm::dvec3(directions[places[end].corner / 3]);
    }
    for (; begin < end; ++begin) {
      Vertex& vertex = mesh.vertices[places[begin].corner];
      const glm::dvec3 along = glm::length(sum) > 0 ? sum : glm::dvec3(directions[places[begin].corner / 3]);
      if (along != glm::dvec3(0)) vertex.tangent = glm::vec3(tangent_along(glm::dvec3(vertex.normal), along));
    }
  }
}

bool has_extent(const Mesh& mesh) {
  const glm::vec3& first = mesh.vertices.front().position;
  return std::ranges::any_of(mesh.vertices, [&](const Vertex& vertex) { return vertex.position != first; });
}

}  // namespace

Result<Mesh> make_mesh(const ObjContent& content) {
  const std::vector<glm::dvec3> smooth = smooth_normals(content);
  Mesh mesh;
  mesh.vertices.reserve(content.triangles.size() * 3);
  mesh.triangles.reserve(content.triangles.size());
  for (const Corners& corners : content.triangles) {
    const auto first = static_cast<uint32_t>(mesh.vertices.size());
    const glm::dvec3 face =
        unit_or_nothing(glm::cross(edge(content, corners[0], corners[1]), edge(content, corners[0], corners[2])));
    for (const ObjCorner& corner : corners) {
      const glm::dvec3 given(corner.normal < 0 ? glm::vec3(0)
                                               : content.normals[static_cast<std::size_t>(corner.normal)]);
      glm::dvec3 normal = unit_or_nothing(given);
      if (normal == glm::dvec3(0)) normal = unit_or_nothing(smooth[static_cast<std::size_t>(corner.position)]);
      if (normal == glm::dvec3(0)) normal = face == glm::dvec3(0) ? glm::dvec3(0, 0, 1) : face;
      mesh.vertices.push_back({position_of(content, corner), glm::vec3(normal), glm::vec3(0)});
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  if (!has_extent(mesh)) return Failure{"all its faces are one point"};
  set_tangents(mesh, content);
  return mesh;
}

}  // namespace texbrdf::objects
