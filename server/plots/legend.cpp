#include "plots/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace texbrdf::plots {
namespace {

/// M. Okabe and K. Ito, "Color Universal Design", 2008.
constexpr std::array<Colour, 7> kPalette = {{{0x00, 0x72, 0xb2},
                                             {0xd5, 0x5e, 0x00},
                                             {0x00, 0x9e, 0x73},
                                             {0xcc, 0x79, 0xa7},
                                             {0xe6, 0x9f, 0x00},
                                             {0x56, 0xb4, 0xe9},
                                             {0x22, 0x22, 0x22}}};
constexpr double kCurveWidth = 1.6;
constexpr double kSampleLength = 26;
constexpr double kGap = 8;
constexpr double kTitleSize = 15;

std::vector<double> dashes_of(std::size_t turn) {
  switch (turn % 4) {
    case 1:
      return {7, 4};
    case 2:
      return {2, 3};
    case 3:
      return {9, 3, 2, 3};
    default:
      return {};
  }
}

Colour channel_colour(Component::Kind kind, Colour otherwise) {
  switch (kind) {
    case Component::Kind::Red:
      return {0xd4, 0x20, 0x2c};
    case Component::Kind::Green:
      return {0x12, 0x8a, 0x3c};
    case Component::Kind::Blue:
      return {0x1f, 0x4f, 0xd8};
    case Component::Kind::Luminance:
    case Component::Kind::Value:
      return otherwise;
  }
  return otherwise;
}

std::string trace_name(const Series& series, const Component& component, bool has_several) {
  if (!has_several) return series.label;
  return series.label.empty() ? std::string(component.word()) : fmt::format("{}, {}", series.label, component.word());
}

std::string fixed_text(const Request& request) {
  const std::string phi = request.phi == 0 ? "" : fmt::format(", φ = {}", degrees_text(request.phi));
  switch (request.view) {
    case View::Lobe:
    case View::Polar:
    case View::ThetaO:
      return fmt::format("θ_i = {}{}", degrees_text(request.incidence), phi);
    case View::ThetaH:
      return fmt::format("θ_d = {}, φ_d = {}{}", degrees_text(request.theta_d), degrees_text(request.phi_d), phi);
    case View::ThetaD:
      return fmt::format("θ_h = {}, φ_d = {}{}", degrees_text(request.theta_h), degrees_text(request.phi_d), phi);
    case View::Albedo:
      return request.phi == 0 ? "" : fmt::format("φ_i = {}", degrees_text(request.phi));
    case View::Slice:
      return fmt::format("φ_d = {}{}", degrees_text(request.phi_d), phi);
  }
  return "";
}

void draw_legend(Canvas& canvas, const std::vector<Trace>& traces, double left, double top) {
  for (const Trace& trace : traces) {
    if (trace.name.empty()) continue;
    canvas.line({left, top}, {left + kSampleLength, top}, trace.stroke);
    canvas.text({left + kSampleLength + kGap, top + 4}, Anchor::Start, plain(trace.name));
    top += kLineHeight;
  }
}

double legend_width(const Canvas& canvas, const std::vector<Trace>& traces) {
  double width = 0;
  for (const Trace& trace : traces) {
    if (!trace.name.empty()) width = std::max(width, canvas.font().width_of(trace.name, kTextSize));
  }
  return width == 0 ? 0 : width + kSampleLength + 2 * kGap;
}

}  // namespace

std::string degrees_text(double degrees) {
  return number_text(degrees) + "°";
}

std::vector<Trace> traces_of(const Plot& plot) {
  std::vector<Trace> traces;
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& series = plot.series[i];
    std::vector<Component> components = components_of(plot, series);
    if (series.is_grey && components.size() > 1) components = {Component{}};
    const bool has_several = components.size() > 1;
    const Colour own = kPalette[i % kPalette.size()];
    for (const Component& component : components) {
      const Colour colour = has_several || plot.series.size() == 1 ? channel_colour(component.kind, own) : own;
      const std::size_t turn = has_several ? i : i / kPalette.size();
      Trace trace;
      trace.series = &series;
      trace.component = component;
      trace.stroke.colour = colour;
      trace.stroke.width = kCurveWidth;
      trace.stroke.dashes = dashes_of(turn);
      trace.name = trace_name(series, component, has_several);
      traces.push_back(std::move(trace));
    }
  }
  return traces;
}

std::string value_label(const Plot& plot) {
  const Request& request = plot.request;
  std::string what = request.view == View::Albedo ? "ρ(θ_i)" : "f(ω_i, ω_o)";
  if (request.times_cosine) {
    const bool is_of_light = request.view == View::Albedo || request.view == View::ThetaH ||
                             request.view == View::ThetaD || request.view == View::Slice;
    what += is_of_light ? " cos θ_i" : " cos θ_o";
  }
  const bool has_colour = std::ranges::any_of(plot.series, &Series::is_colour);
  const std::vector<Component> components = components_of(plot, plot.series.front());
  if (has_colour && components.size() == 1) what += fmt::format(", {}", components.front().word());
  return request.view == View::Albedo ? what : what + " [sr^{−1}]";
}

Layout draw_surroundings(Canvas& canvas, const Plot& plot, const std::vector<Trace>& traces) {
  constexpr double kMargin = 14;
  double top = kMargin;
  if (!plot.title.empty()) {
    canvas.text({kMargin, top + kTitleSize}, Anchor::Start, plain(plot.title), kTitleSize);
    top += kTitleSize + 4;
  }
  if (const std::string fixed = fixed_text(plot.request); !fixed.empty()) {
    canvas.text({kMargin, top + kTextSize}, Anchor::Start, rich(fixed), kTextSize, kFaint);
    top += kLineHeight;
  }
  top += kGap;
  const std::vector<std::string> notes = notes_of(plot);
  const double notes_top = canvas.height() - kMargin / 2 - kLineHeight * static_cast<double>(notes.size());
  for (std::size_t i = 0; i < notes.size(); ++i) {
    canvas.text({kMargin, notes_top + kLineHeight * (static_cast<double>(i) + 0.75)}, Anchor::Start, plain(notes[i]),
                kSmallText, kWarning);
  }
  const double width = legend_width(canvas, traces);
  const double right = canvas.width() - kMargin - (width == 0 ? 0 : std::min(width, canvas.width() / 2));
  draw_legend(canvas, traces, right + kGap, top + kGap);
  return {.plot = {kMargin, top, right, notes_top - kGap}, .notes_top = notes_top};
}

}  // namespace texbrdf::plots
