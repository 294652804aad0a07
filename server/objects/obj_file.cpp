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

/// A face that is not a triangle.
struct Polygon {
  std::size_t face;  ///< how many came before
  std::vector<ObjCorner> corners;
};

/// Takes in what tinyobjloader finds; all of it has been checked.
class Collector {
 public:
  explicit Collector(const std::vector<uint32_t>& face_lines) : face_lines_(face_lines) {}

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
    for (const Polygon& polygon : polygons_) cut(polygon);
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
    for (std::size_t i = 0; i < count; ++i) {
      face.push_back({place_of(corners[i].vertex_index, content_.positions.size()),
                      place_of(corners[i].texcoord_index, content_.texture_places.size()),
                      place_of(corners[i].normal_index, content_.normals.size())});
    }
    if (face.size() == 3) {
      content_.triangles.push_back({face[0], face[1], face[2]});
    } else {
      polygons_.push_back({faces_, std::move(face)});
    }
    ++faces_;
  }

  void cut(const Polygon& polygon) {
    const std::vector<ObjCorner>& face = polygon.corners;
    std::vector<glm::dvec3> places;
    for (const ObjCorner& corner : face) {
      places.emplace_back(content_.positions[static_cast<std::size_t>(corner.position)]);
    }
    if (face.size() > kMaxConcaveCorners && !is_convex(places, polygon_normal(places))) {
      fault_ = fmt::format("line {}: a face of {} corners is not convex; more than {} are not cut into triangles",
                           face_lines_[polygon.face], face.size(), kMaxConcaveCorners);
      return;
    }
    for (const auto& [a, b, c] : cut_polygon(places)) content_.triangles.push_back({face[a], face[b], face[c]});
  }

  const std::vector<uint32_t>& face_lines_;
  ObjContent content_;
  std::size_t faces_ = 0;
  std::vector<Polygon> polygons_;
  std::optional<std::string> fault_;
};

}  // namespace

Result<Mesh> read_obj(std::string_view text) {
  Result<ObjLines> lines = check_obj_lines(text);
  if (!lines) return Failure{lines.error()};
  std::istringstream stream(std::move(lines->text));
  Collector collector(lines->face_lines);
  if (!tinyobj::LoadObjWithCallback(stream, Collector::callbacks(), &collector)) return Failure{"it cannot be read"};
  const Result<ObjContent> content = std::move(collector).take();
  if (!content) return Failure{content.error()};
  return make_mesh(*content);
}

}  // namespace texbrdf::objects
