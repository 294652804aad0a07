#pragma once

#include <string_view>

#include "objects/mesh.h"
#include "source/result.h"

namespace texbrdf::objects {

inline constexpr std::size_t kMaxObjBytes = std::size_t{256} << 20;
inline constexpr std::size_t kMaxObjVertices = 4'000'000;
inline constexpr std::size_t kMaxObjTriangles = 2'000'000;
/// Of one face; a face that is not convex has at most kMaxConcaveCorners.
inline constexpr std::size_t kMaxObjCorners = 1024;
inline constexpr std::size_t kMaxConcaveCorners = 64;

/// A Wavefront .obj file: v, vt, vn and f; everything else in it is of no matter. Faces of more than three corners are
/// cut into triangles. Normals are those of the file; corners without one have the mean of the faces around their
/// vertex, weighted by angle. Tangents go with growing u where the file has texture coordinates. Not moved, not scaled.
/// An error names the line.
Result<Mesh> read_obj(std::string_view text);

}  // namespace texbrdf::objects
