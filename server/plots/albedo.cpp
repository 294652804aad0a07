#include "plots/albedo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "plots/cubature.h"
#include "plots/directions.h"
#include "plots/sampler.h"

namespace texbrdf::plots {
namespace {

constexpr double kLastAngle = 89;
constexpr double kRightAngle = 90;
constexpr double kTurn = 360;
constexpr double kRadians = std::numbers::pi / 180;
constexpr std::size_t kMostCells = 20'000;

/// Where the hemisphere is cut to begin with, in degrees beside the mirrored light, the light and the normal, so that
/// lobes that are narrow are not between all points.
constexpr std::array kCuts = {24.0, 6.0, 1.2};

/// How the steps are spent: the degrees between the lights, and how many of kCuts are made.
struct Plan {
  double step = 1;
  std::size_t cuts = 0;
};

constexpr std::array<Plan, 9> kPlans = {{{1, 3}, {2, 3}, {5, 3}, {5, 1}, {10, 1}, {15, 1}, {15, 0}, {30, 0}, {45, 0}}};

std::vector<double> lights(double step) {
  std::vector<double> angles;
  for (int i = 0; i * step < kLastAngle; ++i) angles.push_back(i * step);
  angles.push_back(kLastAngle);
  return angles;
}

/// From `first` to `last`, cut at `around` and beside it.
void add_cuts(std::vector<double>& places, double around, std::size_t count, double first, double last) {
  if (around > first && around < last) places.push_back(around);
  for (std::size_t i = 0; i < count; ++i) {
    for (const double place : {around - kCuts[i], around + kCuts[i]}) {
      if (place > first && place < last) places.push_back(place);
    }
  }
}

std::vector<double> theta_cuts(double incidence, std::size_t count) {
  std::vector<double> places = {0, kRightAngle};
  add_cuts(places, incidence, count, 0, kRightAngle);
  add_cuts(places, 0, count, 0, kRightAngle);
  std::ranges::sort(places);
  places.erase(std::ranges::unique(places).begin(), places.end());
  return places;
}

/// A turn from the light's side over the mirrored light and back.
std::vector<double> phi_cuts(double phi, std::size_t count) {
  std::vector<double> places = {phi, phi + kTurn};
  for (const double around : {phi, phi + kTurn / 2, phi + kTurn}) add_cuts(places, around, count, phi, phi + kTurn);
  std::ranges::sort(places);
  return places;
}

/// x is sin² theta_o, y is phi_o in degrees: half of dx dy is cos theta_o times the solid angle, so that a constant is
/// integrated exactly.
std::optional<Integral> albedo(Sampler& sampler, double incidence, double phi, const Plan& plan,
                               std::size_t most_cells) {
  const eval::Triple light = direction(incidence, phi);
  const Integrand integrand = [&](double x, double y) {
    const double sine = std::sqrt(x);
    return sampler.value({.light = light, .view = {sine * cosine_of(y), sine * sine_of(y), std::sqrt(1 - x)}});
  };
  std::vector<double> xs = theta_cuts(incidence, plan.cuts);
  for (double& x : xs) x = sine_of(x) * sine_of(x);
  std::optional<Integral> integral =
      integrate(integrand, xs, phi_cuts(phi, plan.cuts), {.relative = 1e-6, .most_cells = most_cells});
  if (!integral) return std::nullopt;
  for (std::size_t c = 0; c < integral->value.size(); ++c) {
    integral->value[c] *= kRadians / 2;
    integral->error[c] *= kRadians / 2;
  }
  return integral;
}

/// Values at the beginning, without any refinement.
double first_values(const Plan& plan) {
  double count = 0;
  for (const double incidence : lights(plan.step)) {
    count += static_cast<double>((theta_cuts(incidence, plan.cuts).size() - 1) * (phi_cuts(0, plan.cuts).size() - 1));
  }
  return count * kPointsOfCell;
}

Plan plan_for(const Sampler& sampler, uint64_t cost) {
  for (const Plan& plan : kPlans) {
    if (2 * first_values(plan) * static_cast<double>(cost) < static_cast<double>(sampler.steps_left())) return plan;
  }
  return kPlans.back();
}

}  // namespace

Curve sample_albedo(const preview::ExactModel& model, const Request& request, const Effort& effort) {
  Curve curve;
  Sampler first(model, effort.steps);
  const uint64_t cost = std::max<uint64_t>(first.cost_of(geometry_in_plane(request, 0)), 1);
  const Plan plan = plan_for(first, cost);
  const std::vector<double> angles = lights(plan.step);
  const uint64_t share = first.steps_left() / angles.size();
  for (const double incidence : angles) {
    Sampler sampler(model, share);
    const std::size_t most_cells = std::min<std::size_t>(kMostCells, share / (2 * kPointsOfCell * cost));
    const std::optional<Integral> integral = albedo(sampler, incidence, request.phi, plan, most_cells);
    if (!integral) {
      Curve none;
      none.problem = kTooSlow;
      return none;
    }
    const double cosine = request.times_cosine ? cosine_of(incidence) : 1;
    eval::Triple value = integral->value;
    eval::Triple error = integral->error;
    for (std::size_t c = 0; c < value.size(); ++c) {
      value[c] *= cosine;
      error[c] *= cosine;
    }
    curve.angles.push_back(incidence);
    curve.values.emplace_back(value);
    curve.errors.push_back(error);
  }
  return curve;
}

}  // namespace texbrdf::plots
