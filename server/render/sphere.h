#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace texbrdf::render {

inline constexpr uint32_t kMaxPictureSize = 4096;

/// A unit sphere that fills 90 % of a square picture (times `zoom`), seen along -z, lit from one direction.
struct SphereView {
  uint32_t size = 256;       ///< pixels, width and height; 1 to kMaxPictureSize
  double theta = 33.8941;    ///< degrees between the light and the view axis
  double phi = 145.826;      ///< degrees of the light around the view axis, counter-clockwise from +x (right)
  double gamma = 2.112;      ///< 0.1 to 10
  double exposure = -1.248;  ///< stops, -60 to 60
  double zoom = 1;           ///< 0.1 to 100
  bool times_cosine = true;  ///< f · N·L, or f alone
  friend bool operator==(const SphereView&, const SphereView&) = default;
};

/// Why the view cannot be drawn, in words, or nothing.
std::optional<std::string> find_fault(const SphereView& view);

/// Of the sphere in pixels.
double sphere_radius(const SphereView& view);

/// A place of a picture in parts of its width, from the top left.
struct PicturePlace {
  double x = 0;
  double y = 0;
};

/// A point of the sphere with its frame; docs/pictures.md gives the formulas.
struct SurfacePoint {
  std::array<double, 3> normal;
  std::array<double, 3> tangent;
  std::array<double, 3> bitangent;
};

/// Towards the light.
std::array<double, 3> light_direction(const SphereView& view);
/// Towards the viewer, whatever the view.
inline constexpr std::array<double, 3> kViewDirection{0, 0, 1};
/// What is seen at a place; nothing beside the sphere and on its silhouette.
std::optional<SurfacePoint> surface_point(const SphereView& view, PicturePlace place);
/// Where a pixel of the picture, counted row by row from the top left, is sampled.
PicturePlace sample_place(const SphereView& view, uint32_t pixel);

/// The surface points of a picture of the sphere that have to be shaded: those in the light.
struct SphereGeometry {
  /// Three arrays of a coordinate each.
  using Vectors = std::array<std::vector<float>, 3>;

  uint32_t size = 0;
  std::array<float, 3> light{};
  std::array<float, 3> view{0, 0, 1};
  std::vector<uint8_t> alpha;    ///< coverage of every pixel of the picture
  std::vector<uint32_t> pixels;  ///< of each point: its pixel, row by row from the top left
  std::vector<float> cosines;    ///< N·L
  Vectors normals;
  Vectors tangents;
  Vectors bitangents;

  std::size_t point_count() const { return pixels.size(); }
};

/// Whether two views show the same points: what is done with their values does not matter.
bool same_geometry(const SphereView& a, const SphereView& b);

/// Which points of the sphere.
enum class SpherePoints : uint8_t { Lit, All };

/// The view has no fault. Cosines of points that are not lit are 0 or less.
SphereGeometry make_sphere_geometry(const SphereView& view, SpherePoints points = SpherePoints::Lit);

/// Keeps the geometry of the view drawn last.
class SphereCache {
 public:
  const SphereGeometry& geometry(const SphereView& view);

 private:
  std::optional<SphereView> view_;
  SphereGeometry geometry_;
};

}  // namespace texbrdf::render
