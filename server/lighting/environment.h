#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace texbrdf::lighting {

/// Light from all directions as a picture twice as wide as high or of another shape: rows from the zenith +y to the
/// nadir -y, each as high as its angle; columns around, the middle of a row in the direction -z, what is right of it
/// towards +x.
struct EnvironmentMap {
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<glm::vec3> radiance;  ///< linear red, green, blue of each texel; finite, not negative
};

/// The unit vector of a place of the picture, in parts of its width and height from the top left.
glm::dvec3 direction_at(const glm::dvec2& place);

/// Light from all directions: the radiance is the same in all of a texel. Immutable.
class Environment {
 public:
  /// Some texel is not black.
  explicit Environment(EnvironmentMap map);
  /// Radiance 1 from everywhere.
  static Environment furnace();

  const glm::vec3& radiance(const glm::dvec3& direction) const { return map_.radiance[texel_of(direction)]; }
  /// How `sample` chooses, per steradian: by luminance.
  double density(const glm::dvec3& direction) const;
  /// A unit vector; `random` is uniform in [0, 1)².
  glm::dvec3 sample(const glm::dvec2& random) const;
  /// Whether the luminance is the same everywhere, so that there is nothing to choose by it.
  bool is_uniform() const { return is_uniform_; }
  const EnvironmentMap& map() const { return map_; }

 private:
  std::size_t texel_of(const glm::dvec3& direction) const;

  EnvironmentMap map_;
  double total_ = 0;            // of luminance times solid angle
  std::vector<double> rows_;    // of it up to and with each row, as a part of the total
  std::vector<float> columns_;  // of each row: of its luminance up to and with each texel, as a part
  bool is_uniform_ = false;
};

/// CIE 1931 luminance of linear sRGB (IEC 61966-2-1).
double luminance(const glm::dvec3& colour);

}  // namespace texbrdf::lighting
