// Any bytes as the file of an object, and as one of light: an error, or what the headers promise.
#include <cmath>
#include <cstdint>
#include <string_view>

#include "lighting/hdr_file.h"
#include "objects/obj_file.h"
#include "objects/rasterise.h"
#include "source/internal_error.h"

namespace {

using namespace texbrdf;

constexpr std::size_t kMaxInput = 1 << 14;

bool is_finite(const glm::vec3& vector) {
  return std::isfinite(vector.x) && std::isfinite(vector.y) && std::isfinite(vector.z);
}

void check_object(std::string_view text) {
  Result<objects::Mesh> mesh = objects::read_obj(text);
  if (!mesh) return require(!mesh.error().empty(), "no mesh, and no reason");
  for (const objects::Triangle& triangle : mesh->triangles) {
    for (const uint32_t corner : triangle) require(corner < mesh->vertices.size(), "no such vertex");
  }
  fit_into_unit_sphere(*mesh);
  for (const objects::Vertex& vertex : mesh->vertices) {
    require(is_finite(vertex.position) && is_finite(vertex.normal) && is_finite(vertex.tangent), "no numbers");
  }
  const glm::dmat3 rotation = objects::rotation_of({20, 30});
  for (const objects::Fragment& fragment : objects::rasterise(*mesh, rotation, 16, 7).fragments) {
    require(objects::frame_at(*mesh, rotation, fragment).normal.z > 0, "a normal away from the viewer");
  }
}

void check_light(std::string_view bytes) {
  const Result<lighting::EnvironmentMap> map = lighting::read_hdr(bytes);
  if (!map) return require(!map.error().empty(), "no map, and no reason");
  require(map->radiance.size() == std::size_t{map->width} * map->height, "the size of a map");
  const lighting::Environment environment(*map);
  for (const double place : {0.0, 0.3, 0.7, 0.999999}) {
    const glm::dvec3 direction = environment.sample({place, 1 - place * 0.5 - 0.25});
    require(std::isfinite(direction.x) && std::isfinite(environment.density(direction)), "a sample");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
  if (size > kMaxInput) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  check_object(bytes);
  check_light(bytes);
  return 0;
}
