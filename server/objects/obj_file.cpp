#include "objects/obj_file.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include "objects/obj_content.h"
#include "objects/obj_lines.h"
#include "objects/polygon.h"

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

namespace texbrdf::objects {

namespace {

/// Takes in what tinyobjloader finds; all of it has been checked.
class Collector {
 public:
  static tinyobj::callback_t callbacks() {
    tinyobj::callback_t calls;
    calls.vertex_cb = [](void* self, float x, float y, float z, float) {
      content(self).positions.emplace_back(x, y, z);
    };
    calls.texcoord_cb = [](void* self, float u, float v, float) { content(self).texture_places.emplace_back(u, v); };
    calls.normal_cb = [](void* self, float x, float y, float z) { content(self).normals.emplace_back(x, y, z); };
    calls.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
      static_cast<Collector*>(self)->add_face(corners, static_cast<std::size_t>(count));
    };
    return calls;
  }

  Result<ObjContent> take() && {
    for (const std::vector<ObjCorner>& face : polygons_) cut(face);
    if (fault_) return Failure{*std::move(fault_)};
    return std::move(content_);
  }

 private:
  static ObjContent& content(void* self) { return static_cast<Collector*>(self)->content_; }

  /// From 1 on, or backwards from the last so far; 0 where there is none.
  static int32_t place_of(int number, std::size_t count) {
    if (number < 0) return static_cast<int32_t>(count) + number;
    return number - 1;
  }

  /// Triangles are kept as they are; others wait until all vertices are known.
  void add_face(const tinyobj::index_t* corners, std::size_t count) {
    std::vector<ObjCorner> face;
    for (std::size_t i = 0; i < count && corners[i].vertex_index != 0; ++i) {  // 0: a comment
      face.push_back({place_of(corners[i].vertex_index, content_.positions.size()),
                      place_of(corners[i].texcoord_index, content_.texture_places.size()),
                      place_of(corners[i].normal_index, content_.normals.size())});
    }
    if (face.size() == 3) {
      content_.triangles.push_back({face[0], face[1], face[2]});
    } else {
      polygons_.push_back(std::move(face));
    }
  }

  void cut(const std::vector<ObjCorner>& face) {
    std::vector<glm::dvec3> places;
    for (const ObjCorner& corner : face) {
      places.emplace_back(content_.positions[static_cast<std::size_t>(corner.position)]);
    }
    if (face.size() > kMaxConcaveCorners && !is_convex(places, polygon_normal(places))) {
      fault_ = fmt::format("a face of {} corners is not convex; more than {} are not cut into triangles", face.size(),
                           kMaxConcaveCorners);
      return;
    }
    for (const auto& [a, b, c] : cut_polygon(places)) content_.triangles.push_back({face[a], face[b], face[c]});
  }

  ObjContent content_;
  std::vector<std::vector<ObjCorner>> polygons_;
  std::optional<std::string> fault_;
};

}  // namespace

Result<Mesh> read_obj(std::string_view text) {
  if (auto wrong = find_obj_fault(text)) return *std::move(wrong);
  std::istringstream stream{std::string(text)};
  Collector collector;
  if (!tinyobj::LoadObjWithCallback(stream, Collector::callbacks(), &collector)) return Failure{"it cannot be read"};
  const Result<ObjContent> content = std::move(collector).take();
  if (!content) return Failure{content.error()};
  return make_mesh(*content);
}

}  // namespace texbrdf::objects
