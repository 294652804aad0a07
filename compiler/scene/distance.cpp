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

double distance_to(const Box& box, const glm::dvec3& place) {
  return box_distance(place - box.centre(), box.half());
}

}  // namespace

double Distances::of(uint32_t index, const glm::dvec3& place) const {
  const PlannedNode& node = plan_.nodes[index];
  const glm::dvec3 local = node.frame.local(place);
  if (!node.guard) return node.frame.factor * inside(node, local);
  const double outside = distance_to(node.guard->box, local);
  const double value =
      outside > node.guard->margin ? node.guard->level + outside : guarded(inside(node, local), outside, *node.guard);
  return node.frame.factor * value;
}

double Distances::united(const PlannedNode& node, const glm::dvec3& place) const {
  double least = kNothing;
  for (const uint32_t child : node.children) least = std::min(least, of(child, place));
  return least;
}

double Distances::joined(const PlannedNode& node, const glm::dvec3& place) const {
  const double k = node.data[0];
  const bool is_subtraction = node.kind == ObjectKind::Subtraction || node.kind == ObjectKind::SmoothSubtraction;
  const bool is_smooth = node.kind == ObjectKind::SmoothSubtraction || node.kind == ObjectKind::SmoothIntersection;
  double value = of(node.children.front(), place);
  for (std::size_t i = 1; i < node.children.size(); ++i) {
    const double other = (is_subtraction ? -1 : 1) * of(node.children[i], place);
    if (node.kind == ObjectKind::SmoothUnion) {
      value = smooth_union(value, other, k);
    } else {
      value = is_smooth ? smooth_intersection(value, other, k) : std::max(value, other);
    }
  }
  return value;
}

double Distances::repeated(const PlannedNode& node, const glm::dvec3& place) const {
  const Repetition& plan = *node.repetition;
  const glm::dvec3 first = first_copy(plan, place - plan.centre);
  double least = plan.level + distance_beside(plan, place - plan.centre, first);
  glm::dvec3 copy;
  for (copy.z = 0; copy.z < plan.window.z; ++copy.z) {
    for (copy.y = 0; copy.y < plan.window.y; ++copy.y) {
      for (copy.x = 0; copy.x < plan.window.x; ++copy.x) {
        const glm::dvec3 q = place - plan.spacing * (first + copy);
        const double box = plan.level + box_distance(q - plan.centre, plan.half);
        if (box < least) least = std::min(least, std::max(box, united(node, q)));
      }
    }
  }
  return least;
}

double Distances::inside(const PlannedNode& node, const glm::dvec3& p) const {
  const auto& d = node.data;
  switch (node.kind) {
    case ObjectKind::InfiniteRepetition:
    case ObjectKind::LimitedRepetition:
      return repeated(node, p);
    case ObjectKind::Displacement: {
      const double value = united(node, p);
      return std::max((value + displacement(p, d[0], d[1])) / node.lipschitz, value - std::abs(d[0]));
    }
    case ObjectKind::Twist: {
      const glm::dvec2 q = turned({p.z, p.x}, -d[0] * p.y);
      const double value = twisted_distance(united(node, {q.y, p.y, q.x}), std::abs(d[0]), std::hypot(p.x, p.z));
      return node.cut ? std::max(value, distance_to(*node.cut, p)) : value;
    }
    case ObjectKind::Bend: {
      const glm::dvec2 q = turned({p.x, p.y}, -d[0] * p.x);
      const double value = bent_distance(united(node, {q.x, q.y, p.z}), std::abs(d[0]), std::hypot(p.x, p.y));
      return node.cut ? std::max(value, distance_to(*node.cut, p)) : value;
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
      return united(node, p);
    case ObjectKind::Subtraction:
    case ObjectKind::Intersection:
    case ObjectKind::SmoothUnion:
    case ObjectKind::SmoothSubtraction:
    case ObjectKind::SmoothIntersection:
      return joined(node, p);
    case ObjectKind::UserPrimitive:
      return united(node, p);
#define HELPER(name, ...)
#define DISTANCE_FUNCTION(kind, name, ...) case ObjectKind::kind:
#include "scene/distance_functions.def"
#undef DISTANCE_FUNCTION
#undef HELPER
      return std::min(primitive_distance(node.kind, p, d), united(node, p));
  }
  throw InternalError("a distance of no object");
}

}  // namespace texbrdf::scene
