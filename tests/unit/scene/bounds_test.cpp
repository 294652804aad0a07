#include "scene/bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "scene/distance.h"
#include "scene/lipschitz.h"
#include "scene/primitives.h"
#include "support/random_scene.h"

// Random trees: what makes them fast and safe must not change what they are.

namespace texbrdf::scene {
namespace {

constexpr uint64_t kScenes = 400;

/// The signs of a scene by the formulas alone: no bounds, and many copies of what is repeated.
class Plain {
 public:
  explicit Plain(const Scene& scene) : plan_(plan_tree(scene, {.guards = false})) {}

  double at(const glm::dvec3& place) const { return of(plan_.root, place); }
  const TreePlan& plan() const { return plan_; }

 private:
  double of(uint32_t index, const glm::dvec3& place) const {
    const PlannedNode& node = plan_.nodes[index];
    return node.frame.factor * inside(node, node.frame.local(place));
  }
  double united(const PlannedNode& node, const glm::dvec3& p) const {
    double least = INFINITY;
    for (const uint32_t child : node.children) least = std::min(least, of(child, p));
    return least;
  }
  double repeated(const PlannedNode& node, const glm::dvec3& p) const {
    constexpr int kCopies = 3;
    const Repetition& plan = *node.repetition;
    double least = INFINITY;
    const glm::dvec3 middle = glm::clamp(glm::round((p - plan.centre) * inverse_spacing(plan)), -plan.last, plan.last);
    const auto reach = [&](int axis) { return plan.spacing[axis] > 0 ? kCopies : 0; };
    for (int x = -reach(0); x <= reach(0); ++x) {
      for (int y = -reach(1); y <= reach(1); ++y) {
        for (int z = -reach(2); z <= reach(2); ++z) {
          const glm::dvec3 copy = glm::clamp(middle + glm::dvec3(x, y, z), -plan.last, plan.last);
          least = std::min(least, united(node, p - plan.spacing * copy));
        }
      }
    }
    return least;
  }
  double inside(const PlannedNode& node, const glm::dvec3& p) const {
    const auto& d = node.data;
    if (is_primitive(node.kind)) return std::min(primitive_distance(node.kind, p, d), united(node, p));
    if (node.repetition) return repeated(node, p);
    const auto joined = [&](auto&& join) {
      double value = of(node.children.front(), p);
      for (std::size_t i = 1; i < node.children.size(); ++i) value = join(value, of(node.children[i], p));
      return value;
    };
    switch (object_entry(node.kind).object_class) {
      case ObjectClass::Binary:
        if (node.kind == ObjectKind::Union) return united(node, p);
        if (node.kind == ObjectKind::Subtraction) return joined([](double a, double b) { return std::max(a, -b); });
        if (node.kind == ObjectKind::Intersection) return joined([](double a, double b) { return std::max(a, b); });
        if (node.kind == ObjectKind::SmoothUnion)
          return joined([&](double a, double b) { return smooth_union(a, b, d[0]); });
        if (node.kind == ObjectKind::SmoothSubtraction)
          return joined([&](double a, double b) { return smooth_intersection(a, -b, d[0]); });
        return joined([&](double a, double b) { return smooth_intersection(a, b, d[0]); });
      default:
        break;
    }
    switch (node.kind) {
      case ObjectKind::Displacement:
        return (united(node, p) + displacement(p, d[0], d[1])) / node.lipschitz;
      case ObjectKind::Twist: {
        const glm::dvec2 q = turned({p.z, p.x}, -d[0] * p.y);
        return united(node, {q.y, p.y, q.x});
      }
      case ObjectKind::Bend: {
        const glm::dvec2 q = turned({p.x, p.y}, -d[0] * p.x);
        return united(node, {q.x, q.y, p.z});
      }
      case ObjectKind::Symmetry:
        return united(node, glm::mix(p, glm::abs(p), glm::dvec3(d[0], d[1], d[2])));
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
      default:
        return united(node, {std::hypot(p.x, p.z) - d[0], p.y, 0});
    }
  }

  TreePlan plan_;
};

/// Whether the plain formulas say where the surfaces are: what offsets a twist or displacement is defined by its bound,
/// and what is repeated and larger than the window is cut off.
bool has_plain_meaning(const TreePlan& plan) {
  return std::ranges::all_of(plan.nodes, [&](const PlannedNode& node) {
    const bool is_deforming =
        node.kind == ObjectKind::Twist || node.kind == ObjectKind::Bend || node.kind == ObjectKind::Displacement;
    if (is_deforming && node.level > 0) return false;
    if (!node.repetition) return true;
    const Box box = children_box(plan, node, node.repetition->level);
    for (int axis = 0; axis < 3; ++axis) {
      if (node.repetition->spacing[axis] == 0) continue;
      if (!box.is_bounded() || node.repetition->half[axis] < box.half()[axis] - 1e-9) return false;
    }
    return true;
  });
}

TEST(Bounds, SurfacesAreWhereTheFormulasSay) {
  int compared = 0;
  for (uint64_t seed = 1; seed <= kScenes; ++seed) {
    test::RandomScene random(seed);
    const Scene scene = random.make();
    const Plain plain(scene);
    if (!has_plain_meaning(plain.plan())) continue;
    ++compared;
    const Distances guarded(scene);
    const Distances unguarded(scene, {.guards = false});
    for (int i = 0; i < 300; ++i) {
      const glm::dvec3 p = random.place();
      const double expected = plain.at(p);
      if (std::abs(expected) < 1e-9) continue;
      ASSERT_EQ(unguarded.at(p) > 0, expected > 0) << "seed " << seed << ", " << unguarded.at(p) << ", " << expected;
      ASSERT_EQ(guarded.at(p) > 0, expected > 0) << "seed " << seed << ", " << guarded.at(p) << ", " << expected;
    }
  }
  EXPECT_GT(compared, 100);
}

/// Places in the ball that a value keeps free are on the same side of the surface.
TEST(Bounds, NoSurfaceIsNearerThanTheValueSays) {
  int compared = 0;
  for (uint64_t seed = 1; seed <= kScenes; ++seed) {
    test::RandomScene random(seed);
    const Scene scene = random.make();
    const Plain plain(scene);
    if (!has_plain_meaning(plain.plan())) continue;
    const Distances guarded(scene);
    for (int i = 0; i < 20; ++i) {
      const glm::dvec3 p = random.place();
      const double free = std::abs(guarded.at(p)) * (1 - 1e-6) - 1e-9;
      if (!(free > 0)) continue;
      const bool is_outside = plain.at(p) > 0;
      for (const double part : {0.5, 0.8, 0.95, 0.99, 1.0}) {
        for (int j = 0; j < 6; ++j) {
          ++compared;
          const glm::dvec3 q = p + glm::normalize(random.place()) * (free * part);
          ASSERT_EQ(plain.at(q) > 0, is_outside)
              << "seed " << seed << ", " << free << " around " << p.x << ' ' << p.y << ' ' << p.z;
        }
      }
    }
  }
  EXPECT_GT(compared, 30'000);
}

TEST(Bounds, GuardsChangeNothingNearSurfacesNorAnySign) {
  constexpr double kNear = 1e-3;
  int near = 0;
  for (uint64_t seed = 1; seed <= kScenes; ++seed) {
    test::RandomScene random(seed, true);
    const Scene scene = random.make();
    const Distances guarded(scene);
    const Distances unguarded(scene, {.guards = false});
    for (int i = 0; i < 60; ++i) {
      glm::dvec3 p = random.place();
      const glm::dvec3 step = glm::normalize(random.place());
      for (int j = 0; j < 25 && std::abs(unguarded.at(p)) > kNear / 2; ++j) p += step * std::abs(unguarded.at(p)) * 0.9;
      const double expected = unguarded.at(p);
      if (std::abs(expected) < kNear) {
        ++near;
        ASSERT_NEAR(guarded.at(p), expected, 1e-12) << "seed " << seed;
      } else {
        ASSERT_EQ(guarded.at(p) > 0, expected > 0) << "seed " << seed;
      }
    }
  }
  EXPECT_GT(near, 2000);
}

/// Chords are no steeper than the function is somewhere between; a place and a far one are compared too.
TEST(Bounds, NoSlopeExceedsOne) {
  for (uint64_t seed = 1; seed <= kScenes; ++seed) {
    test::RandomScene random(seed, true);
    const Scene scene = random.make();
    for (const bool guards : {true, false}) {
      const Distances distances(scene, {.guards = guards});
      for (int i = 0; i < 300; ++i) {
        const glm::dvec3 p = random.place();
        for (const double length : {1e-5, 0.01, 1.0}) {
          const glm::dvec3 q = p + glm::normalize(random.place()) * length;
          ASSERT_LE(std::abs(distances.at(p) - distances.at(q)), length * (1 + 1e-4) + 1e-9)
              << "seed " << seed << ", guards " << guards << ", length " << length << " at " << p.x << ' ' << p.y << ' '
              << p.z;
        }
      }
    }
  }
}

TEST(Bounds, LevelBoxesHoldWhatIsBelowTheLevel) {
  for (uint64_t seed = 1; seed <= kScenes; ++seed) {
    test::RandomScene random(seed);
    const Scene scene = random.make(8);
    const TreePlan plan = plan_tree(scene, {.guards = false});
    const Distances distances(scene, {.guards = false});
    for (const double level : {0.0, 0.1, 0.7}) {
      const Box box = level_box(plan, plan.root, level);
      for (int i = 0; i < 200; ++i) {
        const glm::dvec3 p = random.place(5);
        if (distances.at(p) > level) continue;
        for (int axis = 0; axis < 3; ++axis) {
          ASSERT_LE(box.low[axis], p[axis] + 1e-9) << "seed " << seed << ", level " << level;
          ASSERT_GE(box.high[axis], p[axis] - 1e-9) << "seed " << seed << ", level " << level;
        }
      }
    }
  }
}

}  // namespace
}  // namespace texbrdf::scene
