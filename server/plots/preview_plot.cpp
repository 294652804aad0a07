#include "plots/preview_plot.h"

#include <cmath>

namespace texbrdf::plots {
namespace {

constexpr uint64_t kCurveSteps = 500'000;
constexpr uint64_t kSurfaceSteps = 1'500'000;

}  // namespace

Request request_beside(const render::SphereView& view, View plotted) {
  Request request;
  request.view = plotted;
  const double theta = std::remainder(view.theta, 360);
  request.incidence = std::abs(theta);
  request.phi = theta < 0 ? view.phi + 180 : view.phi;
  request.times_cosine = view.times_cosine;
  return request;
}

std::optional<std::string> problem_of(const Request& request) {
  const bool has_light = request.view == View::Lobe || request.view == View::Polar || request.view == View::ThetaO;
  if (has_light && request.incidence >= 90) return "the light is behind the surface";
  return std::nullopt;
}

Effort quick_effort(View plotted) {
  switch (plotted) {
    case View::Polar:
    case View::ThetaO:
    case View::ThetaH:
    case View::ThetaD:
      return {.steps = kCurveSteps};
    case View::Lobe:
    case View::Albedo:
    case View::Slice:
      return {.steps = kSurfaceSteps};
  }
  return {};
}

}  // namespace texbrdf::plots
