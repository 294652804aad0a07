#include "preview/plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace texbrdf::preview {
namespace {

/// Of the reference evaluator, over all angles together: some 10 ms.
constexpr uint64_t kMaxSteps = 500'000;
/// Steps of a half degree from -90 to 90.
constexpr int kIntervals = 360;
/// The widths of a step to choose from, in half degrees: all divide 90°, so that there is a sample at 0.
constexpr std::array kStrides = {1, 2, 4, 10, 20, 60, 180};

/// The plane through the normal and the light, in the tangent frame of the middle of the sphere.
class PlaneOfIncidence {
 public:
  explicit PlaneOfIncidence(const render::SphereView& view) : light_(render::light_direction(view)) {
    const double phi = view.phi * std::numbers::pi / 180;
    const double length = std::hypot(light_[0], light_[1]);
    towards_light_ = {length > 0 ? light_[0] / length : std::cos(phi), length > 0 ? light_[1] / length : std::sin(phi)};
  }

  double light_theta() const { return std::acos(std::clamp(light_[2], -1.0, 1.0)) * 180 / std::numbers::pi; }
  bool is_lit() const { return light_[2] > 0; }

  eval::Geometry geometry(double degrees) const {
    const double sine = sin_degrees(degrees);
    return {.light = light_,
            .view = {-sine * towards_light_[0], -sine * towards_light_[1], sin_degrees(90 - std::abs(degrees))}};
  }

 private:
  /// Exact at 0 and 90°: the horizon is where N·V is 0.
  static double sin_degrees(double degrees) {
    if (std::abs(degrees) == 90) return degrees / 90;
    return std::sin(degrees * std::numbers::pi / 180);
  }

  eval::Triple light_;
  std::array<double, 2> towards_light_;
};

Plot sample(const ExactModel& model, const render::SphereView& view, int stride, eval::StepBudget& budget) {
  const PlaneOfIncidence plane(view);
  Plot plot = empty_plot(view, {});
  for (int i = 0; i <= kIntervals; i += stride) {
    const double degrees = (i - kIntervals / 2) / 2.0;
    const eval::Geometry geometry = plane.geometry(degrees);
    std::optional<eval::Triple> value = model.value(geometry, budget);
    if (!value) return empty_plot(view, "the BRDF is too slow to be plotted");
    if (view.times_cosine) std::ranges::for_each(*value, [&](double& channel) { channel *= geometry.view[2]; });
    plot.angles.push_back(degrees);
    plot.values.push_back(*value);
  }
  return plot;
}

/// The narrowest step for which the budget is enough, if all samples cost as much as the one at the normal.
int affordable_stride(const ExactModel& model, const render::SphereView& view, eval::StepBudget& budget) {
  const uint64_t before = budget.left;
  model.value(PlaneOfIncidence(view).geometry(0), budget);
  const uint64_t cost = before - budget.left;
  const auto* const stride = std::ranges::find_if(
      kStrides, [&](int width) { return cost * static_cast<uint64_t>(kIntervals / width + 1) <= budget.left; });
  return stride == kStrides.end() ? kStrides.back() : *stride;
}

}  // namespace

Plot plot(const ExactModel& model, const render::SphereView& view) {
  if (!PlaneOfIncidence(view).is_lit()) return empty_plot(view, "the light is behind the surface");
  eval::StepBudget budget{kMaxSteps};
  const int stride = affordable_stride(model, view, budget);
  return sample(model, view, stride, budget);
}

Plot empty_plot(const render::SphereView& view, std::string problem) {
  return {
      .light_theta = PlaneOfIncidence(view).light_theta(), .angles = {}, .values = {}, .problem = std::move(problem)};
}

}  // namespace texbrdf::preview
