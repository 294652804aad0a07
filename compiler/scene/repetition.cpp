#include "scene/repetition.h"

#include <algorithm>
#include <cmath>

namespace texbrdf::scene {
namespace {

constexpr double kLargest = 1e15;  // its square is finite in single precision
constexpr double kManyCopies = 1e9;

// In spacings: what fits its cell by this leaves a gap for steps from cell to cell.
constexpr double kFitting = 0.45;
/// From the middle of the last copy that is asked to the boxes of the next.
constexpr double kLeastRest = 0.25;

/// The smallest window outside of which boxes of that half size, in spacings, are at least kLeastRest away.
double window_for(double half, double copies) {
  if (half <= kFitting) return 1;
  const double beyond = std::max(0.0, std::ceil(half - (1 - kLeastRest)));
  return std::min({2 + 2 * beyond, kMaxCopiesAsked, copies});
}

/// The largest half size, in spacings, of boxes for a window.
double reach_of(double window) {
  return window == 1 ? kFitting : window / 2 - kLeastRest;
}

double count(const glm::dvec3& window) {
  return window.x * window.y * window.z;
}

/// Takes copies from the largest window until few enough are asked.
void limit(glm::dvec3& window) {
  while (count(window) > kMaxCopiesAsked) {
    double& largest = *std::max_element(&window.x, &window.x + 3);
    largest = std::max(2.0, 2 * std::ceil(largest / 2) - 2);
  }
}

}  // namespace

Repetition plan_repetition(const PlannedNode& node, const Box& children, double level) {
  const auto& d = node.data;
  const bool is_limited = node.kind == ObjectKind::LimitedRepetition;
  Repetition plan;
  plan.level = level;
  plan.spacing = is_limited ? glm::dvec3(d[0]) : glm::dvec3(d[0], d[1], d[2]);
  plan.last = is_limited ? glm::dvec3(d[1], d[2], d[3]) : glm::dvec3(kManyCopies);
  for (int axis = 0; axis < 3; ++axis) {
    if (plan.spacing[axis] == 0 || plan.last[axis] == 0) plan.spacing[axis] = plan.last[axis] = 0;
    const bool is_bounded = !children.is_empty() && children.is_bounded(axis);
    plan.centre[axis] = is_bounded ? children.centre()[axis] : 0;
    plan.half[axis] = is_bounded ? std::min(children.half()[axis], kLargest) : kLargest;
    if (plan.spacing[axis] > 0)
      plan.window[axis] =
          window_for(std::min(plan.half[axis] / plan.spacing[axis], kManyCopies), 2 * plan.last[axis] + 1);
  }
  limit(plan.window);
  for (int axis = 0; axis < 3; ++axis) {
    const bool has_all = plan.window[axis] == 2 * plan.last[axis] + 1;
    if (has_all) continue;
    plan.half[axis] = std::min(plan.half[axis], reach_of(plan.window[axis]) * plan.spacing[axis]);
  }
  return plan;
}

}  // namespace texbrdf::scene
