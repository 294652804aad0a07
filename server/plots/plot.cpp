#include "plots/plot.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "plots/albedo.h"
#include "plots/channels.h"
#include "plots/draw_curves.h"
#include "plots/draw_lobe.h"
#include "plots/draw_slice.h"

namespace texbrdf::plots {
namespace {

/// How many of the numbers have no place, by reason.
struct Missing {
  std::size_t not_numbers = 0;
  std::size_t not_positive = 0;
  std::size_t negative = 0;
};

Missing missing_of(const Plot& plot) {
  Missing missing;
  for (const double number : shown_numbers(plot)) {
    if (!std::isfinite(number)) {
      ++missing.not_numbers;
    } else if (plot.look.scale == ScaleKind::Log && number <= 0) {
      ++missing.not_positive;
    } else if (number < 0) {
      ++missing.negative;
    }
  }
  return missing;
}

}  // namespace

std::optional<std::string> find_fault(const Look& look) {
  for (const uint32_t side : {look.width, look.height}) {
    if (side < kLeastSize || side > kMostSize) {
      return fmt::format("the size has to be {} to {} pixels, got {}", kLeastSize, kMostSize, side);
    }
  }
  if (look.maximum && !(*look.maximum > 0 && std::isfinite(*look.maximum))) {
    return fmt::format("the maximum has to be a positive number, got {}", *look.maximum);
  }
  return std::nullopt;
}

Result<Series> sample(const preview::ExactModel& model, std::string label, const Request& request,
                      const Effort& effort) {
  Series series{.label = std::move(label), .is_colour = model.brdf().type != Type::Real, .samples = {}};
  const bool is_grid = request.view == View::Lobe || request.view == View::Slice;
  if (is_grid) {
    Grid grid = request.view == View::Lobe ? sample_lobe(model, request, effort) : sample_slice(model, request, effort);
    if (!grid.problem.empty()) return Failure{grid.problem};
    series.samples = std::move(grid);
    return series;
  }
  Curve curve =
      request.view == View::Albedo ? sample_albedo(model, request, effort) : sample_curve(model, request, effort);
  if (!curve.problem.empty()) return Failure{curve.problem};
  series.samples = std::move(curve);
  return series;
}

Drawing draw(const Plot& plot) {
  switch (plot.request.view) {
    case View::Polar:
      return draw_polar(plot);
    case View::ThetaO:
    case View::ThetaH:
    case View::ThetaD:
    case View::Albedo:
      return draw_cartesian(plot);
    case View::Lobe:
      return draw_lobe(plot);
    case View::Slice:
      return draw_slice(plot);
  }
  return {};
}

std::vector<std::string> notes_of(const Plot& plot) {
  const Missing missing = missing_of(plot);
  std::vector<std::string> notes;
  if (missing.not_numbers > 0) notes.push_back(fmt::format("{} values are no finite numbers", missing.not_numbers));
  if (missing.not_positive > 0) {
    notes.push_back(
        fmt::format("{} values are 0 or negative and have no place on a logarithmic axis", missing.not_positive));
  }
  if (missing.negative > 0) {
    const bool has_place = plot.request.view != View::Polar && plot.request.view != View::Lobe;
    notes.push_back(fmt::format("{} values are negative{}", missing.negative, has_place ? "" : " and not shown"));
  }
  return notes;
}

}  // namespace texbrdf::plots
