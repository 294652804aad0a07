#include "plots/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "plots/channels.h"
#include "plots/draw_curves.h"
#include "plots/draw_lobe.h"
#include "plots/draw_slice.h"
#include "plots/legend.h"

namespace texbrdf::plots {
namespace {

const std::vector<Sample>& values_of(const Series& series) {
  const auto* const curve = std::get_if<Curve>(&series.samples);
  return curve != nullptr ? curve->values : std::get<Grid>(series.samples).values;
}

bool is_grey(const Series& series) {
  return std::ranges::all_of(values_of(series), [](const Sample& value) {
    const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    return !value || (same((*value)[0], (*value)[1]) && same((*value)[1], (*value)[2]));
  });
}

/// Why a number has no place in a picture.
using Misfit = bool (*)(double number, const Plot& plot);

bool is_no_number(double number, const Plot&) {
  return !std::isfinite(number);
}

bool is_not_positive(double number, const Plot& plot) {
  return plot.look.scale == ScaleKind::Log && number <= 0 && std::isfinite(number);
}

bool is_negative(double number, const Plot& plot) {
  return plot.look.scale == ScaleKind::Linear && number < 0 && std::isfinite(number);
}

/// "2 of 361 samples", and which they are where they are few.
std::string samples_text(const Series& series, const std::vector<std::size_t>& samples) {
  constexpr std::size_t kFew = 3;
  const auto* const curve = std::get_if<Curve>(&series.samples);
  std::string text = fmt::format("{} of {} samples", samples.size(), values_of(series).size());
  if (curve == nullptr || samples.size() > kFew) return text;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    text += fmt::format("{} {}", i == 0 ? " (at" : ",", degrees_text(curve->angles[samples[i]]));
  }
  return text + ")";
}

void add_note(std::vector<std::string>& notes, const Plot& plot, const Series& series, Misfit is_misfit,
              std::string_view what) {
  const std::vector<Component> components = components_of(plot, series);
  const std::vector<Sample>& values = values_of(series);
  std::vector<std::size_t> misfits;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool has_misfit = values[i] && std::ranges::any_of(components, [&](const Component& component) {
                              return is_misfit(component.of(*values[i]), plot);
                            });
    if (has_misfit) misfits.push_back(i);
  }
  if (misfits.empty()) return;
  const std::string whose = series.label.empty() ? "" : series.label + ": ";
  notes.push_back(fmt::format("{}{} at {}", whose, what, samples_text(series, misfits)));
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
  const bool can_be_seen = std::abs(look.azimuth) <= 3600 && look.elevation >= 0 && look.elevation <= 90;
  if (!can_be_seen) return "a lobe is seen from an azimuth in degrees and an elevation of 0 to 90 degrees";
  return std::nullopt;
}

Result<Series> sample(const preview::ExactModel& model, std::string label, const Request& request,
                      const Effort& effort) {
  Series series;
  series.label = std::move(label);
  series.is_colour = model.brdf().type != Type::Real;
  if (has_grid(request.view)) {
    Grid grid = sample_grid(model, request, effort);
    if (!grid.problem.empty()) return Failure{grid.problem};
    series.samples = std::move(grid);
    series.is_grey = is_grey(series);
    return series;
  }
  Curve curve = sample_curve(model, request, effort);
  if (!curve.problem.empty()) return Failure{curve.problem};
  series.samples = std::move(curve);
  series.is_grey = is_grey(series);
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
  const bool has_place =
      plot.request.view != View::Polar && plot.request.view != View::Lobe && plot.request.view != View::Slice;
  const std::string_view negative = has_place ? "negative values" : "negative values, not shown,";
  std::vector<std::string> notes;
  for (const Series& series : plot.series) {
    add_note(notes, plot, series, is_no_number, "no finite number");
    add_note(notes, plot, series, is_not_positive, "values that are not above 0, not shown,");
    add_note(notes, plot, series, is_negative, negative);
  }
  return notes;
}

}  // namespace texbrdf::plots
