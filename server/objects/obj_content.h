#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "objects/mesh.h"
#include "source/result.h"

namespace texbrdf::objects {

/// Places in the lists of ObjContent; -1 where the corner has none.
struct ObjCorner {
  int32_t position = -1;
  int32_t texture_place = -1;
  int32_t normal = -1;
};

/// What of a .obj file matters here, its faces cut into triangles; all places exist.
struct ObjContent {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec2> texture_places;
  std::vector<glm::vec3> normals;
  std::vector<std::array<ObjCorner, 3>> triangles;
};

/// Forms the normals that are missing, and tangents. Fails where all vertices of triangles are in one place.
Result<Mesh> make_mesh(const ObjContent& content);

}  // namespace texbrdf::objects
