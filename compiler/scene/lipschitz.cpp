#include "scene/lipschitz.h"

#include <cmath>
#include <limits>

#include "scene/bounds.h"

namespace texbrdf::scene {
namespace {

double bound_of(const TreePlan& plan, const PlannedNode& node) {
  if (node.kind != ObjectKind::Twist && node.kind != ObjectKind::Bend) return node.lipschitz;
  const Box box = children_box(plan, node, 0);
  if (!box.is_bounded()) return node.data[0] == 0 ? 1 : std::numeric_limits<double>::infinity();
  if (node.kind == ObjectKind::Twist) return twist_slope(node.data[0], radius_about(box, 0, 2));
  return bend_slope(node.data[0], radius_about(box, 0, 1));
}

}  // namespace

double displacement_slope(double amplitude, double frequency) {
  return 1 + std::abs(amplitude * frequency);
}

double twist_slope(double k, double radius) {
  const double a = std::abs(k) * radius;
  return (a + std::sqrt(a * a + 4)) / 2;
}

double bend_slope(double k, double radius) {
  return 1 + std::abs(k) * radius;
}

std::vector<double> lipschitz_bounds(const Scene& scene) {
  const TreePlan plan = plan_tree(scene, {.guards = false});
  std::vector<double> bounds(scene.nodes.size(), 1);
  for (const PlannedNode& node : plan.nodes) {
    if (node.node.valid()) bounds[node.node.value] = bound_of(plan, node);
  }
  return bounds;
}

}  // namespace texbrdf::scene
