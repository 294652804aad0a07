#include "plots/samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <string_view>
#include <utility>

#include "plots/albedo.h"
#include "plots/directions.h"
#include "plots/sampler.h"

namespace texbrdf::plots {
namespace {

constexpr double kRightAngle = 90;
constexpr double kTurn = 360;

/// Steps of a curve to choose from, in degrees: all divide 90, so that there is a sample at 0.
constexpr std::array kCurveSteps = {0.5, 1.0, 2.0, 5.0, 10.0, 30.0, 90.0};
/// Cells of a slice's side to choose from.
constexpr std::array kSliceCells = {180, 90, 45, 30, 15, 9, 5, 3, 1};
/// Degrees between neighbours on the hemisphere to choose from.
constexpr std::array kLobeSteps = {2.0, 3.0, 5.0, 10.0, 15.0, 30.0};
/// Beside the mirrored light, for lobes that are narrower than the steps.
constexpr std::array kLobeDetail = {0.25, 0.5, 1.0, 1.5, 3.0, 4.5};

using ValueAt = std::function<Sample(double angle)>;

double middle(double a, double b) {
  return a + (b - a) / 2;
}

bool is_number(const Sample& value) {
  return value && std::ranges::all_of(*value, [](double channel) { return std::isfinite(channel); });
}

/// Halves the intervals where the curve is not as straight as it would be drawn.
class Refinement {
 public:
  Refinement(Curve curve, const ValueAt& value_at) : old_(std::move(curve)), value_at_(value_at) {}

  Curve refined(int times) {
    for (const Sample& value : old_.values) {
      if (is_number(value))
        largest_ = std::max({largest_, std::abs((*value)[0]), std::abs((*value)[1]), std::abs((*value)[2])});
    }
    for (std::size_t i = 0; i < old_.angles.size(); ++i) {
      if (i > 0) add_between({old_.angles[i - 1], old_.values[i - 1]}, {old_.angles[i], old_.values[i]}, times);
      add({old_.angles[i], old_.values[i]});
    }
    return std::move(curve_);
  }

 private:
  struct Point {
    double angle = 0;
    Sample value;
  };

  /// Of the largest value: less than the width of a line.
  static constexpr double kStraight = 0.002;

  void add(const Point& point) {
    curve_.angles.push_back(point.angle);
    curve_.values.push_back(point.value);
  }

  void add_between(const Point& left, const Point& right, int times) {
    if (times == 0 || !is_number(left.value) || !is_number(right.value)) return;
    const double angle = middle(left.angle, right.angle);
    const Point between{angle, value_at_(angle)};
    if (!is_number(between.value) || is_straight(*left.value, *between.value, *right.value)) return;
    add_between(left, between, times - 1);
    add(between);
    add_between(between, right, times - 1);
  }

  bool is_straight(const eval::Triple& left, const eval::Triple& between, const eval::Triple& right) const {
    for (std::size_t c = 0; c < left.size(); ++c) {
      if (std::abs(middle(left[c], right[c]) - between[c]) > kStraight * largest_) return false;
    }
    return true;
  }

  Curve old_;
  const ValueAt& value_at_;
  Curve curve_;
  double largest_ = 0;
};

/// The first of `choices`, finest first, whose number of values the sampler can pay for, or the last of them.
template <typename Choice>
Choice affordable(std::span<const Choice> choices, const Sampler& sampler, uint64_t cost,
                  const std::function<double(Choice)>& count) {
  const auto found = std::ranges::find_if(choices, [&](Choice choice) {
    return static_cast<double>(cost) * count(choice) <= static_cast<double>(sampler.steps_left());
  });
  return found == choices.end() ? choices.back() : *found;
}

/// Steps between the ends, and the angle where a mirror would send the light.
std::vector<double> angles_between(double first, double last, double step, double mirror) {
  std::vector<double> angles;
  const int intervals = static_cast<int>(std::lround((last - first) / step));
  for (int i = 0; i <= intervals; ++i) angles.push_back(first + i * step);
  const auto place = std::ranges::lower_bound(angles, mirror);
  if (mirror > first && mirror < last && *place != mirror) angles.insert(place, mirror);
  return angles;
}

struct CurveRange {
  double first = 0;
  double last = kRightAngle;
};

bool is_in_plane(const Request& request) {
  return request.view == View::Polar || request.view == View::ThetaO;
}

CurveRange range_of(const Request& request) {
  return is_in_plane(request) ? CurveRange{-kRightAngle, kRightAngle} : CurveRange{};
}

HalfAngles half_angles(const Request& request, double theta_h, double theta_d) {
  return {.theta_h = theta_h, .phi_h = request.phi, .theta_d = theta_d, .phi_d = request.phi_d};
}

eval::Geometry geometry_at(const Request& request, double angle) {
  if (request.view == View::ThetaH) return geometry_of(half_angles(request, angle, request.theta_d));
  if (request.view == View::ThetaD) return geometry_of(half_angles(request, request.theta_h, angle));
  return geometry_in_plane(request, angle);
}

/// Of the viewer where the light stands still, else of the light.
double cosine_at(const Request& request, const eval::Geometry& geometry) {
  if (!request.times_cosine) return 1;
  const bool is_over_half_angles =
      request.view == View::ThetaH || request.view == View::ThetaD || request.view == View::Slice;
  return is_over_half_angles ? geometry.light[2] : geometry.view[2];
}

Curve without_values(std::string_view problem) {
  Curve curve;
  curve.problem = problem;
  return curve;
}

Grid no_grid(std::string_view problem) {
  Grid grid;
  grid.problem = problem;
  return grid;
}

/// The values of a grid whose angles are there.
Grid filled(Grid grid, Sampler& sampler, const Request& request,
            const std::function<eval::Geometry(double, double)>& geometry_of_cell) {
  grid.values.reserve(grid.rows.size() * grid.columns.size());
  for (const double row : grid.rows) {
    for (const double column : grid.columns) {
      const eval::Geometry geometry = geometry_of_cell(row, column);
      grid.values.push_back(sampler.value(geometry, cosine_at(request, geometry)));
      if (sampler.is_exhausted()) return no_grid(kTooSlow);
    }
  }
  return grid;
}

/// Ascending, without those that nearly are the same.
std::vector<double> tidied(std::vector<double> angles) {
  constexpr double kSame = 1e-9;
  std::ranges::sort(angles);
  const auto same = std::ranges::unique(angles, [](double a, double b) { return b - a < kSame; });
  angles.erase(same.begin(), same.end());
  return angles;
}

void add_detail(std::vector<double>& angles, double around, double first, double last) {
  angles.push_back(std::clamp(around, first, last));
  for (const double offset : kLobeDetail) {
    if (around - offset > first) angles.push_back(around - offset);
    if (around + offset < last) angles.push_back(around + offset);
  }
}

Grid lobe_angles(const Request& request, double step) {
  Grid grid;
  grid.rows = angles_between(0, kRightAngle, step, request.incidence);
  add_detail(grid.rows, request.incidence, 0, kRightAngle);
  const double behind_mirror = request.phi;  // the turn begins and ends on the light's side
  grid.columns = angles_between(behind_mirror, behind_mirror + kTurn, 2 * step, behind_mirror + kTurn / 2);
  add_detail(grid.columns, behind_mirror + kTurn / 2, behind_mirror, behind_mirror + kTurn);
  grid.rows = tidied(std::move(grid.rows));
  grid.columns = tidied(std::move(grid.columns));
  return grid;
}

Grid sample_lobe(const preview::ExactModel& model, const Request& request, const Effort& effort) {
  Sampler sampler(model, effort.steps);
  const uint64_t cost = sampler.cost_of(geometry_in_plane(request, 0));
  const double step = affordable<double>(kLobeSteps, sampler, cost, [&](double width) {
    const Grid angles = lobe_angles(request, width);
    return static_cast<double>(angles.rows.size() * angles.columns.size());
  });
  return filled(lobe_angles(request, step), sampler, request,
                [&](double theta, double phi) { return geometry_of_viewer(request, theta, phi); });
}

Grid sample_slice(const preview::ExactModel& model, const Request& request, const Effort& effort) {
  Sampler sampler(model, effort.steps);
  const uint64_t cost = sampler.cost_of(geometry_of(half_angles(request, 0, 0)));
  const int cells = affordable<int>(kSliceCells, sampler, cost, [](int side) { return double{1} * side * side; });
  Grid grid;
  for (int i = 0; i < cells; ++i) grid.rows.push_back((i + 0.5) * kRightAngle / cells);
  grid.columns = grid.rows;
  return filled(std::move(grid), sampler, request,
                [&](double theta_d, double theta_h) { return geometry_of(half_angles(request, theta_h, theta_d)); });
}

}  // namespace

eval::Geometry geometry_in_plane(const Request& request, double theta_o) {
  const eval::Triple view = direction(std::abs(theta_o), request.phi + (theta_o < 0 ? 0 : kTurn / 2));
  return {.light = direction(request.incidence, request.phi), .view = view};
}

eval::Geometry geometry_of_viewer(const Request& request, double theta_o, double phi_o) {
  return {.light = direction(request.incidence, request.phi), .view = direction(theta_o, phi_o)};
}

bool has_grid(View view) {
  return view == View::Lobe || view == View::Slice;
}

Grid sample_grid(const preview::ExactModel& model, const Request& request, const Effort& effort) {
  return request.view == View::Lobe ? sample_lobe(model, request, effort) : sample_slice(model, request, effort);
}

Curve sample_curve(const preview::ExactModel& model, const Request& request, const Effort& effort) {
  if (request.view == View::Albedo) return sample_albedo(model, request, effort);
  Sampler sampler(model, effort.steps);
  const auto [first, last] = range_of(request);
  const uint64_t cost = sampler.cost_of(geometry_at(request, 0));
  const double step =
      affordable<double>(kCurveSteps, sampler, cost, [&](double width) { return (last - first) / width + 2; });
  const ValueAt value_at = [&](double angle) {
    const eval::Geometry geometry = geometry_at(request, angle);
    return sampler.value(geometry, cosine_at(request, geometry));
  };
  Curve curve;
  const bool has_mirror = is_in_plane(request) && effort.refinements > 0;
  curve.angles = angles_between(first, last, step, has_mirror ? request.incidence : first);
  for (const double angle : curve.angles) {
    curve.values.push_back(value_at(angle));
    if (sampler.is_exhausted()) return without_values(kTooSlow);
  }
  return Refinement(std::move(curve), value_at).refined(effort.refinements);
}

}  // namespace texbrdf::plots
