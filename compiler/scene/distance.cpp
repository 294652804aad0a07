#include "scene/distance.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "scene/primitives.h"
#include "source/internal_error.h"

namespace texbrdf::scene {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();

double join(ObjectKind kind, double a, double b, double k) {
  switch (kind) {
    case ObjectKind::Subtraction:
      return std::max(a, -b);
    case ObjectKind::Intersection:
      return std::max(a, b);
    case ObjectKind::SmoothUnion:
      return smooth_union(a, b, k);
    case ObjectKind::SmoothSubtraction:
      return smooth_intersection(a, -b, k);
    case ObjectKind::SmoothIntersection:
      return smooth_intersection(a, b, k);
    default:
      return std::min(a, b);
  }
}

}  // namespace

Distances::Distances(const Scene& scene) : scene_(scene) {
  for (const Node& node : scene.nodes) frames_.push_back(frame_of(node.transform));
}

double Distances::at(const glm::dvec3& place) const {
  double least = kNothing;
  for (const NodeId root : scene_.roots) least = std::min(least, of(root, place));
  return least;
}

double Distances::of(NodeId node, const glm::dvec3& place) const {
  const Frame& frame = frames_[node.value];
  return frame.factor * inside(scene_.node(node), frame.local(place));
}

double Distances::united(const Node& node, const glm::dvec3& place) const {
  double least = kNothing;
  for (const NodeId child : node.children) least = std::min(least, of(child, place));
  return least;
}

double Distances::joined(const Node& node, const glm::dvec3& place) const {
  double value = of(node.children.front(), place);
  for (std::size_t i = 1; i < node.children.size(); ++i) {
    value = join(node.kind, value, of(node.children[i], place), node.data[0]);
  }
  return value;
}

/// The copy whose cell the place is in, and the next ones: up to eight.
double Distances::repeated(const Node& node, const glm::dvec3& place) const {
  const bool limited = node.kind == ObjectKind::LimitedRepetition;
  glm::dvec3 spacing(node.data[0], node.data[1], node.data[2]);
  glm::dvec3 last(kNothing);
  if (limited) {
    spacing = glm::dvec3(node.data[0]);
    last = {node.data[1], node.data[2], node.data[3]};
  }
  double least = kNothing;
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec3 q = place;
    for (int axis = 0; axis < 3; ++axis) {
      if (spacing[axis] == 0) continue;
      const double cell = place[axis] / spacing[axis];
      const double copy = (corner >> axis & 1) != 0 ? std::ceil(cell) : std::floor(cell);
      q[axis] -= spacing[axis] * std::clamp(copy, -last[axis], last[axis]);
    }
    least = std::min(least, united(node, q));
  }
  return least;
}

double Distances::inside(const Node& node, const glm::dvec3& p) const {
  const auto& d = node.data;
  switch (node.kind) {
    case ObjectKind::InfiniteRepetition:
    case ObjectKind::LimitedRepetition:
      return repeated(node, p);
    case ObjectKind::Displacement:
      return united(node, p) + displacement(p, d[0], d[1]);
    case ObjectKind::Twist: {
      const glm::dvec2 q = turned({p.z, p.x}, -d[0] * p.y);
      return united(node, {q.y, p.y, q.x});
    }
    case ObjectKind::Bend: {
      const glm::dvec2 q = turned({p.x, p.y}, -d[0] * p.x);
      return united(node, {q.x, q.y, p.z});
    }
    case ObjectKind::Symmetry:
      return united(
          node, {d[0] == 0 ? p.x : std::abs(p.x), d[1] == 0 ? p.y : std::abs(p.y), d[2] == 0 ? p.z : std::abs(p.z)});
    case ObjectKind::Rounding:
      return united(node, p) - d[0];
    case ObjectKind::Shell:
      return std::abs(united(node, p)) - d[0];
    case ObjectKind::Elongation: {
      const glm::dvec3 h(d[0], d[1], d[2]);
      return united(node, p - glm::clamp(p, -h, h));
    }
    case ObjectKind::Extrusion:
      return length_above({united(node, {p.x, p.y, 0}), std::abs(p.z) - d[0]});
    case ObjectKind::Revolution:
      return united(node, {std::hypot(p.x, p.z) - d[0], p.y, 0});
    case ObjectKind::Union:
    case ObjectKind::Subtraction:
    case ObjectKind::Intersection:
    case ObjectKind::SmoothUnion:
    case ObjectKind::SmoothSubtraction:
    case ObjectKind::SmoothIntersection:
      return joined(node, p);
    case ObjectKind::UserPrimitive:
      return united(node, p);
    default:  // the primitives
      return std::min(primitive_distance(node.kind, p, d), united(node, p));
  }
}

}  // namespace texbrdf::scene
