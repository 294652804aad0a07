#include "scene/bounds.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "source/internal_error.h"

namespace texbrdf::scene {
namespace {

using Data = std::array<double, kMaxData>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRoom = 0.02;  // of a size

Box centred(double x, double y, double z) {
  return box_around(glm::dvec3(0), {x, y, z});
}

/// A half space is a box only where its normal lies along an axis.
Box half_space(const Data& d) {
  Box box = everything();
  const glm::dvec3 normal(d[0], d[1], d[2]);
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(normal[axis]) != glm::length(normal)) continue;
    (normal[axis] > 0 ? box.high : box.low)[axis] = -d[3] / normal[axis];
  }
  return box;
}

Box triangle(double half_side, double z) {
  const double below = half_side / std::numbers::sqrt3;
  return {{-half_side, -below, -z}, {half_side, 2 * below, z}};
}

Box solid_angle(double angle, double radius) {
  const double width = angle < std::numbers::pi / 2 ? radius * std::sin(angle) : radius;
  return {{-width, std::min(0.0, radius * std::cos(angle)), -width}, {width, radius, width}};
}

Box curve(const Data& d) {
  const Box box{{std::min({d[0], d[2], d[4]}), std::min({d[1], d[3], d[5]}), -kInfinity},
                {std::max({d[0], d[2], d[4]}), std::max({d[1], d[3], d[5]}), kInfinity}};
  return grown(box, d[6]);
}

/// Of the primitive alone. Grown by `level` it has all places where the primitive says at most that.
Box primitive_box(const PlannedNode& node) {
  const Data& d = node.data;
  switch (node.kind) {
    case ObjectKind::Sphere:
      return centred(d[0], d[0], d[0]);
    case ObjectKind::Cuboid:
    case ObjectKind::RoundedCuboid:
      return centred(d[0], d[1], d[2]);
    case ObjectKind::Plane:
      return half_space(d);
    case ObjectKind::Torus:
      return centred(d[0] + d[1], d[1], d[0] + d[1]);
    case ObjectKind::CappedTorus:
      return centred(d[1] + d[2], d[1] + d[2], d[2]);
    case ObjectKind::Cylinder:
      return centred(d[1], d[0], d[1]);
    case ObjectKind::Capsule:
      return centred(d[1], d[0] + d[1], d[1]);
    case ObjectKind::Cone: {
      const double radius = d[1] * std::tan(d[0]);
      return {{-radius, -d[1], -radius}, {radius, 0, radius}};
    }
    case ObjectKind::CappedCone:
      return centred(std::max(d[1], d[2]), d[0], std::max(d[1], d[2]));
    case ObjectKind::Ellipsoid:  // its function is at least the distance to the box less this
      return grown(centred(d[0], d[1], d[2]), 0.1 * std::min({d[0], d[1], d[2]}));
    case ObjectKind::Octahedron:
      return centred(d[0], d[0], d[0]);
    case ObjectKind::HexagonalPrism:
      return centred(d[0] * 2 / std::numbers::sqrt3, d[0], d[1]);
    case ObjectKind::TriangularPrism:
      return triangle(d[0] * std::numbers::sqrt3 / 2, d[1]);
    case ObjectKind::Pyramid:
      return {{-0.5, 0, -0.5}, {0.5, d[0], 0.5}};
    case ObjectKind::Link:
      return centred(d[1] + d[2], d[0] + d[1] + d[2], d[2]);
    case ObjectKind::InfiniteCylinder:
      return box_around({d[0], 0, d[1]}, {d[2], kInfinity, d[2]});
    case ObjectKind::SolidAngle:
      return solid_angle(d[0], d[1]);
    case ObjectKind::Circle:
      return centred(d[0], d[0], kInfinity);
    case ObjectKind::Box:
    case ObjectKind::RoundedBox:
      return centred(d[0], d[1], kInfinity);
    case ObjectKind::EquilateralTriangle:
      return triangle(d[0], kInfinity);
    case ObjectKind::Cross:
      return centred(d[0], d[0], kInfinity);
    case ObjectKind::Vesica:
      return centred(d[0] - d[1], std::sqrt(d[0] * d[0] - d[1] * d[1]), kInfinity);
    case ObjectKind::QuadraticBezier:
      return curve(d);
    case ObjectKind::UserPrimitive:
      return node.bounds ? centred((*node.bounds)[0], (*node.bounds)[1], (*node.bounds)[2]) : everything();
    case ObjectKind::InfiniteRepetition:
    case ObjectKind::LimitedRepetition:
    case ObjectKind::Displacement:
    case ObjectKind::Twist:
    case ObjectKind::Bend:
    case ObjectKind::Symmetry:
    case ObjectKind::Rounding:
    case ObjectKind::Shell:
    case ObjectKind::Elongation:
    case ObjectKind::Extrusion:
    case ObjectKind::Revolution:
    case ObjectKind::Union:
    case ObjectKind::Subtraction:
    case ObjectKind::Intersection:
    case ObjectKind::SmoothUnion:
    case ObjectKind::SmoothSubtraction:
    case ObjectKind::SmoothIntersection:
      break;
  }
  throw InternalError("primitive_box of an operation");
}

Box repeated(Box box, const PlannedNode& node) {
  for (int axis = 0; axis < 3; ++axis) {
    const bool is_limited = node.kind == ObjectKind::LimitedRepetition;
    const double reach = is_limited                                       ? node.data[0] * node.data[axis + 1]
                         : node.data[static_cast<std::size_t>(axis)] == 0 ? 0
                                                                          : kInfinity;
    box.low[axis] -= reach;
    box.high[axis] += reach;
  }
  return box;
}

Box mirrored(Box box, const Data& axes) {
  for (int axis = 0; axis < 3; ++axis) {
    if (axes[static_cast<std::size_t>(axis)] != 0) box.low[axis] = -box.high[axis];
  }
  return box;
}

Box elongated(const Box& box, const glm::dvec3& half) {
  return {glm::min(box.low, 0.0) - half, glm::max(box.high, 0.0) + half};
}

Box revolved(const Box& box, double radius) {
  const double reach = std::max(box.high.x + radius, 0.0);
  return {{-reach, box.low.y, -reach}, {reach, box.high.y, reach}};
}

Box extruded(const Box& box, double half_length) {
  return {{box.low.x, box.low.y, -half_length}, {box.high.x, box.high.y, half_length}};
}

double largest(double a, double b) {
  return std::max(std::abs(a), std::abs(b));
}

Box all_of(const TreePlan& plan, const PlannedNode& node, double level) {
  Box box = everything();
  for (const uint32_t child : node.children) box = intersection(box, placed_box(plan, child, level));
  return box;
}

}  // namespace

double radius_about(const Box& box, int first_axis, int second_axis) {
  return std::hypot(largest(box.low[first_axis], box.high[first_axis]),
                    largest(box.low[second_axis], box.high[second_axis]));
}

std::optional<Box> deformed_box(const TreePlan& plan, const PlannedNode& node) {
  const Box box = children_box(plan, node, 0);
  if (!box.is_bounded()) return std::nullopt;
  const bool is_twist = node.kind == ObjectKind::Twist;
  const double radius = is_twist ? radius_about(box, 0, 2) : radius_about(box, 0, 1);
  const Box turned = is_twist ? Box{{-radius, box.low.y, -radius}, {radius, box.high.y, radius}}
                              : Box{{-radius, -radius, box.low.z}, {radius, radius, box.high.z}};
  return grown(turned, kRoom * turned.size());
}

Box children_box(const TreePlan& plan, const PlannedNode& node, double level) {
  Box box;
  for (const uint32_t child : node.children) box = hull(box, placed_box(plan, child, level));
  return box;
}

Box placed_box(const TreePlan& plan, uint32_t index, double level) {
  const PlannedNode& node = plan.nodes[index];
  if (node.dynamic) return everything();
  return in_parent(node.frame, level_box(plan, index, level / node.frame.factor));
}

Box level_box(const TreePlan& plan, uint32_t index, double level) {
  const PlannedNode& node = plan.nodes[index];
  const auto& d = node.data;
  const auto children = [&](double at) { return children_box(plan, node, at); };
  switch (node.kind) {
    case ObjectKind::InfiniteRepetition:
    case ObjectKind::LimitedRepetition:
      return repeated(children(level), node);
    case ObjectKind::Displacement:
      return children(level + std::abs(d[0]));
    case ObjectKind::Twist:
    case ObjectKind::Bend: {
      const std::optional<Box> box = deformed_box(plan, node);
      return box ? grown(*box, level) : everything();
    }
    case ObjectKind::Symmetry:
      return mirrored(children(level), d);
    case ObjectKind::Rounding:
    case ObjectKind::Shell:
      return children(level + d[0]);
    case ObjectKind::Elongation:
      return elongated(children(level), {d[0], d[1], d[2]});
    case ObjectKind::Extrusion:
      return extruded(children(level), d[0] + level);
    case ObjectKind::Revolution:
      return revolved(children(level), d[0]);
    case ObjectKind::Union:
      return children(level);
    case ObjectKind::SmoothUnion:  // smaller than the least by less than k, however many there are
      return children(level + d[0]);
    case ObjectKind::Subtraction:
    case ObjectKind::SmoothSubtraction:
      return placed_box(plan, node.children.front(), level);
    case ObjectKind::Intersection:
    case ObjectKind::SmoothIntersection:
      return all_of(plan, node, level);
    case ObjectKind::UserPrimitive:
#define HELPER(name, ...)
#define DISTANCE_FUNCTION(kind, name, ...) case ObjectKind::kind:
#include "scene/distance_functions.def"
#undef DISTANCE_FUNCTION
#undef HELPER
      return hull(grown(primitive_box(node), level), children(level));
  }
  throw InternalError("level_box of no object");
}

}  // namespace texbrdf::scene
