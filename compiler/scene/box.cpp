#include "scene/box.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace texbrdf::scene {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What turns an infinite object by less than this does not count: quarter turns are written with few digits.
constexpr double kNoTurn = 1e-7;

double product(double coefficient, double coordinate, double largest) {
  if (std::isinf(coordinate) && std::abs(coefficient) < kNoTurn * largest) return 0;
  return coefficient == 0 ? 0 : coefficient * coordinate;
}

}  // namespace

bool Box::is_empty() const {
  return !(low.x <= high.x && low.y <= high.y && low.z <= high.z);
}

bool Box::is_bounded() const {
  return !is_empty() && is_bounded(0) && is_bounded(1) && is_bounded(2);
}

bool Box::is_bounded(int axis) const {
  return std::isfinite(low[axis]) && std::isfinite(high[axis]);
}

double Box::size() const {
  return std::max({half().x, half().y, half().z});
}

Box box_around(const glm::dvec3& centre, const glm::dvec3& half) {
  return {centre - half, centre + half};
}

Box everything() {
  return {glm::dvec3(-kInfinity), glm::dvec3(kInfinity)};
}

Box hull(const Box& a, const Box& b) {
  if (a.is_empty()) return b;
  if (b.is_empty()) return a;
  return {glm::min(a.low, b.low), glm::max(a.high, b.high)};
}

Box intersection(const Box& a, const Box& b) {
  return {glm::max(a.low, b.low), glm::min(a.high, b.high)};
}

Box grown(const Box& box, double distance) {
  if (box.is_empty()) return box;
  return {box.low - distance, box.high + distance};
}

Box in_parent(const Frame& frame, const Box& box) {
  if (box.is_empty()) return box;
  Box result{frame.position, frame.position};
  for (int to = 0; to < 3; ++to) {
    for (int from = 0; from < 3; ++from) {
      const glm::dvec3& column = frame.to_parent[from];
      const double largest = std::max({std::abs(column.x), std::abs(column.y), std::abs(column.z)});
      const double a = product(column[to], box.low[from], largest);
      const double b = product(column[to], box.high[from], largest);
      result.low[to] += std::min(a, b);
      result.high[to] += std::max(a, b);
    }
  }
  return result;
}

}  // namespace texbrdf::scene
