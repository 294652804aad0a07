#include "scene/tree_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/bounds.h"
#include "scene/lipschitz.h"
#include "scene/repetition.h"
#include "source/internal_error.h"

namespace texbrdf::scene {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A union of more children is one of unions, each of which can be skipped.
constexpr std::size_t kMostChildren = 8;
/// What costs as much as this many primitives is worth a guard.
constexpr double kWorthGuarding = 3;
constexpr double kMargin = 0.05;  // of the size of a box
constexpr double kLargestSize = 1e15;

/// Adds the nodes of a scene, children before parents.
class Planner {
 public:
  Planner(const Scene& scene, const PlanOptions& options) : scene_(scene), options_(options) {
    uint32_t count = 0;
    dynamic_.resize(scene.nodes.size());
    for (std::size_t i = 0; i < scene.nodes.size(); ++i) {
      if (scene.nodes[i].dynamic) dynamic_[i] = count++;
    }
  }

  TreePlan run() {
    PlannedNode root;
    plan_.root = add_operation(std::move(root), scene_.roots);
    return std::move(plan_);
  }

 private:
  uint32_t add(NodeId id) {
    const Node& node = scene_.node(id);
    PlannedNode planned;
    planned.kind = node.kind;
    planned.data = node.data;
    planned.frame = frame_of(node.transform);
    planned.dynamic = dynamic_[id.value];
    planned.leaf = id.value;
    planned.node = id;
    if (node.kind == ObjectKind::UserPrimitive) {
      const UserPrimitive& primitive = scene_.user_primitives[node.user_primitive.value];
      planned.user_primitive = node.user_primitive;
      planned.bounds = primitive.bounds;
      planned.lipschitz = primitive.lipschitz;
    }
    if (node.kind == ObjectKind::Displacement) planned.lipschitz = displacement_slope(node.data[0], node.data[1]);
    return add_operation(std::move(planned), node.children);
  }

  uint32_t add_operation(PlannedNode node, const std::vector<NodeId>& children) {
    for (const NodeId child : children) node.children.push_back(add(child));
    if (joins_by_union(node.kind)) node.children = grouped(std::move(node.children));
    if (!is_primitive(node.kind)) node.leaf = plan_.nodes[node.children.front()].leaf;
    plan_.nodes.push_back(std::move(node));
    return static_cast<uint32_t>(plan_.nodes.size() - 1);
  }

  static bool joins_by_union(ObjectKind kind) {
    return kind == ObjectKind::UserPrimitive || kind == ObjectKind::Union ||
           object_entry(kind).object_class != ObjectClass::Binary;
  }

  /// Many children as few unions of what is near each other; those without bounds stay.
  std::vector<uint32_t> grouped(std::vector<uint32_t> children) {
    if (!options_.guards || children.size() <= kMostChildren) return children;
    std::vector<std::pair<uint32_t, glm::dvec3>> bounded;
    std::vector<uint32_t> result;
    for (const uint32_t child : children) {
      const Box box = placed_box(plan_, child, 0);
      if (box.is_bounded()) {
        bounded.emplace_back(child, box.centre());
      } else {
        result.push_back(child);
      }
    }
    if (bounded.empty()) return children;
    result.push_back(group(bounded));
    return result;
  }

  using Placed = std::pair<uint32_t, glm::dvec3>;

  uint32_t group(std::span<Placed> children) {
    if (children.size() == 1) return children.front().first;
    PlannedNode node;
    if (children.size() <= kMostChildren) {
      for (const Placed& child : children) node.children.push_back(child.first);
    } else {
      const std::size_t half = children.size() / 2;
      const int axis = widest_axis(children);
      std::nth_element(children.begin(), children.begin() + static_cast<std::ptrdiff_t>(half), children.end(),
                       [axis](const Placed& a, const Placed& b) {
                         return std::pair(a.second[axis], a.first) < std::pair(b.second[axis], b.first);
                       });
      node.children = {group(children.first(half)), group(children.subspan(half))};
    }
    node.leaf = plan_.nodes[node.children.front()].leaf;
    plan_.nodes.push_back(std::move(node));
    return static_cast<uint32_t>(plan_.nodes.size() - 1);
  }

  static int widest_axis(std::span<const Placed> children) {
    Box box;
    for (const Placed& child : children) box = hull(box, {child.second, child.second});
    const glm::dvec3 size = box.half();
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
  }

  const Scene& scene_;
  const PlanOptions& options_;
  std::vector<std::optional<uint32_t>> dynamic_;  // by node
  TreePlan plan_;
};

/// What a node must keep of its children's values, for what it must keep of its own. In its own frame.
double level_of_children(const TreePlan& plan, const PlannedNode& node) {
  const double level = node.level;
  const auto& d = node.data;
  switch (node.kind) {
    case ObjectKind::Displacement:
      return level * node.lipschitz + std::abs(d[0]);
    case ObjectKind::Twist:
    case ObjectKind::Bend: {
      if (level == 0) return 0;
      const std::optional<Box> box = deformed_box(plan, node);
      if (!box) return kInfinity;
      const bool is_twist = node.kind == ObjectKind::Twist;
      const double radius = radius_about(*box, 0, is_twist ? 2 : 1) + 2 * level;
      return level * (is_twist ? twist_slope(d[0], radius) : bend_slope(d[0], radius));
    }
    case ObjectKind::Rounding:
    case ObjectKind::Shell:
      return level + d[0];
    case ObjectKind::SmoothUnion:
    case ObjectKind::SmoothSubtraction:
    case ObjectKind::SmoothIntersection:
      // What is at least k from the other counts for nothing, and each join takes or adds k / 4 at most.
      return level + 1.25 * d[0] * static_cast<double>(node.children.size() - 1);
    case ObjectKind::InfiniteRepetition:
    case ObjectKind::LimitedRepetition:
    case ObjectKind::Symmetry:
    case ObjectKind::Elongation:
    case ObjectKind::Extrusion:
    case ObjectKind::Revolution:
    case ObjectKind::Union:
    case ObjectKind::Subtraction:
    case ObjectKind::Intersection:
    case ObjectKind::UserPrimitive:
#define HELPER(name, ...)
#define DISTANCE_FUNCTION(kind, name, ...) case ObjectKind::kind:
#include "scene/distance_functions.def"
#undef DISTANCE_FUNCTION
#undef HELPER
      return level;
  }
  throw InternalError("level_of_children of no object");
}

void find_levels(TreePlan& plan) {
  for (std::size_t i = plan.nodes.size(); i-- > 0;) {
    const PlannedNode& node = plan.nodes[i];
    const double level = level_of_children(plan, node);
    for (const uint32_t child : node.children) {
      PlannedNode& below = plan.nodes[child];
      // A dynamic object may be scaled later.
      below.level = below.dynamic && level > 0 ? kInfinity : level / below.frame.factor;
    }
  }
}

/// In primitives.
double cost_of(const PlannedNode& node, const std::vector<double>& costs) {
  double cost = is_primitive(node.kind) ? 1 : 0.5;
  if (node.kind == ObjectKind::UserPrimitive || node.kind == ObjectKind::Twist || node.kind == ObjectKind::Bend ||
      node.kind == ObjectKind::Displacement || node.kind == ObjectKind::QuadraticBezier) {
    cost += 2;
  }
  double copies = 1;
  if (node.repetition) copies = node.repetition->window.x * node.repetition->window.y * node.repetition->window.z;
  for (const uint32_t child : node.children) cost += copies * costs[child];
  return cost;
}

std::optional<Guard> guard_of(const TreePlan& plan, uint32_t index) {
  const double level = plan.nodes[index].level;
  if (!std::isfinite(level)) return std::nullopt;
  const Box box = level_box(plan, index, level);
  if (!box.is_bounded() || !(box.size() < kLargestSize)) return std::nullopt;
  const double margin = kMargin * box.size();
  const Guard guard{level_box(plan, index, level + margin), level + margin, margin};
  if (!guard.box.is_bounded() || margin <= 0) return std::nullopt;
  return guard;
}

/// What is worth one, children before parents. Of a child that is all of its parent, the parent's is enough.
void add_guards(TreePlan& plan, const std::vector<double>& costs) {
  for (uint32_t i = 0; i < plan.nodes.size(); ++i) {
    PlannedNode& node = plan.nodes[i];
    if (costs[i] < kWorthGuarding) continue;
    node.guard = guard_of(plan, i);
    const bool is_around_one = node.children.size() == 1 && !is_primitive(node.kind);
    if (!is_around_one || !(node.guard || node.repetition)) continue;
    PlannedNode& child = plan.nodes[node.children.front()];
    if (!child.dynamic) child.guard.reset();
  }
}

}  // namespace

bool is_primitive(ObjectKind kind) {
  return kind == ObjectKind::UserPrimitive || object_entry(kind).id != 0;
}

TreePlan plan_tree(const Scene& scene, const PlanOptions& options) {
  TreePlan plan = Planner(scene, options).run();
  find_levels(plan);
  std::vector<double> costs;
  for (PlannedNode& node : plan.nodes) {
    if (node.kind == ObjectKind::InfiniteRepetition || node.kind == ObjectKind::LimitedRepetition) {
      const double level = std::isfinite(node.level) ? node.level : 0;
      const Box tight = children_box(plan, node, level);
      const double room = tight.is_bounded() ? kMargin * tight.size() : 0;
      node.repetition = plan_repetition(node, children_box(plan, node, level + room), level + room);
    }
    if (node.kind == ObjectKind::Twist || node.kind == ObjectKind::Bend) node.cut = deformed_box(plan, node);
    costs.push_back(cost_of(node, costs));
  }
  if (options.guards) add_guards(plan, costs);
  return plan;
}

std::vector<uint32_t> material_of_nodes(const Scene& scene) {
  const auto default_material = static_cast<uint32_t>(scene.materials.size());
  std::vector<uint32_t> materials(scene.nodes.size(), default_material);
  const auto take = [&](NodeId id, uint32_t inherited) {
    const MaterialId own = scene.node(id).material;
    materials[id.value] = own.valid() ? own.value : inherited;
  };
  for (const NodeId root : scene.roots) take(root, default_material);
  for (std::size_t i = scene.nodes.size(); i-- > 0;) {
    for (const NodeId child : scene.nodes[i].children) take(child, materials[i]);
  }
  return materials;
}

}  // namespace texbrdf::scene
