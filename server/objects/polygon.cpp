#include "objects/polygon.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>

namespace texbrdf::objects {

namespace {

using Cut = std::vector<std::array<uint32_t, 3>>;

/// Along the normal: above 0 where a, b, c turn as the polygon does.
double turn(const glm::dvec3& normal, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::dot(normal, glm::cross(b - a, c - b));
}

Cut fan(std::span<const uint32_t> corners) {
  Cut cut;
  for (std::size_t i = 2; i < corners.size(); ++i) cut.push_back({corners[0], corners[i - 1], corners[i]});
  return cut;
}

class EarCutter {
 public:
  EarCutter(std::span<const glm::dvec3> corners, const glm::dvec3& normal)
      : places_(corners), normal_(normal), left_(corners.size()) {
    std::iota(left_.begin(), left_.end(), 0U);
  }

  Cut cut() {
    Cut ears;
    while (left_.size() > 3) {
      const std::size_t ear = find_ear();
      const std::size_t count = left_.size();
      ears.push_back({left_[(ear + count - 1) % count], left_[ear], left_[(ear + 1) % count]});
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    ears.push_back({left_[0], left_[1], left_[2]});
    return ears;
  }

 private:
  std::size_t find_ear() const {
    for (std::size_t i = 0; i < left_.size(); ++i) {
      if (is_ear(i)) return i;
    }
    return 0;
  }

  bool is_ear(std::size_t tip) const {
    const std::size_t count = left_.size();
    const uint32_t a = left_[(tip + count - 1) % count];
    const uint32_t b = left_[tip];
    const uint32_t c = left_[(tip + 1) % count];
    if (!(turn(normal_, places_[a], places_[b], places_[c]) > 0)) return false;
    return std::ranges::none_of(left_, [&](uint32_t other) {
      return !is_at(other, a) && !is_at(other, b) && !is_at(other, c) && is_inside(places_[other], a, b, c);
    });
  }

  /// A polygon with a hole is one whose way there and back has the same corners twice.
  bool is_at(uint32_t corner, uint32_t other) const { return places_[corner] == places_[other]; }

  bool is_inside(const glm::dvec3& place, uint32_t a, uint32_t b, uint32_t c) const {
    return turn(normal_, places_[a], places_[b], place) >= 0 && turn(normal_, places_[b], places_[c], place) >= 0 &&
           turn(normal_, places_[c], places_[a], place) >= 0;
  }

  std::span<const glm::dvec3> places_;
  glm::dvec3 normal_;
  std::vector<uint32_t> left_;
};

}  // namespace

glm::dvec3 polygon_normal(std::span<const glm::dvec3> corners) {
  glm::dvec3 sum(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  }
  return sum;
}

bool is_convex(std::span<const glm::dvec3> corners, const glm::dvec3& normal) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3& next = corners[(i + 1) % corners.size()];
    if (turn(normal, corners[i], next, corners[(i + 2) % corners.size()]) < 0) return false;
  }
  return true;
}

Cut cut_polygon(std::span<const glm::dvec3> corners) {
  std::vector<uint32_t> all(corners.size());
  std::iota(all.begin(), all.end(), 0U);
  const glm::dvec3 normal = polygon_normal(corners);
  return is_convex(corners, normal) ? fan(all) : EarCutter(corners, normal).cut();
}

}  // namespace texbrdf::objects
