#include "plots/draw_curves.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "plots/canvas.h"
#include "plots/directions.h"
#include "plots/legend.h"
#include "plots/polylines.h"

namespace texbrdf::plots {
namespace {

const Curve& curve_of(const Trace& trace) {
  return std::get<Curve>(trace.series->samples);
}

Runs angle_label(View view) {
  switch (view) {
    case View::ThetaH:
      return rich("θ_h [degrees]");
    case View::ThetaD:
      return rich("θ_d [degrees]");
    case View::Albedo:
      return rich("θ_i [degrees]");
    case View::Lobe:
    case View::Polar:
    case View::ThetaO:
    case View::Slice:
      break;
  }
  return rich("θ_o [degrees], positive away from the light");
}

void draw_traces(Canvas& canvas, const std::vector<Trace>& traces, const Scale& scale, const Placement& placement) {
  for (const Trace& trace : traces) {
    Path path{.lines = lines_through(curve_of(trace), trace.component, scale, placement), .stroke = trace.stroke};
    if (!path.lines.empty()) canvas.add(std::move(path));
  }
}

/// From value - error to value + error.
void draw_error_band(Canvas& canvas, const Trace& trace, const Scale& scale, const Placement& placement) {
  const Curve& curve = curve_of(trace);
  std::vector<Point> upper;
  std::vector<Point> lower;
  for (std::size_t i = 0; i < curve.errors.size(); ++i) {
    const double number = trace.component.of(*curve.values[i]);
    const double error = trace.component.of(curve.errors[i]);
    const auto above = scale.fraction_of(number + error);
    if (!above) continue;
    upper.push_back(placement(curve.angles[i], std::clamp(*above, 0.0, 1.0)));
    lower.push_back(placement(curve.angles[i], std::clamp(scale.fraction_of(number - error).value_or(0), 0.0, 1.0)));
  }
  if (upper.size() < 2) return;
  upper.insert(upper.end(), lower.rbegin(), lower.rend());
  Colour colour = trace.stroke.colour;
  colour.opacity = 0.25;
  canvas.add(Path{.lines = {std::move(upper)}, .is_closed = true, .fill = colour});
}

struct AngleAxis {
  double low = 0;
  double high = 90;
  double step = 15;
};

AngleAxis angle_axis(View view) {
  const bool is_in_plane = view == View::ThetaO || view == View::Polar;
  return is_in_plane ? AngleAxis{-90, 90, 30} : AngleAxis{};
}

void draw_axes(Canvas& canvas, const Plot& plot, const Rectangle& frame, const Scale& scale,
               const Placement& placement) {
  const Stroke grid{.colour = kGridLines};
  for (const double tick : scale.ticks) {
    const double y = placement(0, scale.fraction_of(tick).value_or(0)).y;
    canvas.line({frame.left, y}, {frame.right, y}, grid);
    canvas.text({frame.left - 6, y + 4}, Anchor::End, tick_text(scale, tick), kSmallText);
  }
  const AngleAxis axis = angle_axis(plot.request.view);
  for (double angle = axis.low; angle <= axis.high; angle += axis.step) {
    const double x = placement(angle, 0).x;
    canvas.line({x, frame.top}, {x, frame.bottom}, grid);
    canvas.line({x, frame.bottom}, {x, frame.bottom + 4}, {.colour = kInk});
    canvas.text({x, frame.bottom + 17}, Anchor::Middle, plain(degrees_text(angle)), kSmallText);
  }
  canvas.polyline({{frame.left, frame.top}, {frame.left, frame.bottom}, {frame.right, frame.bottom}}, {.colour = kInk});
  canvas.text({(frame.left + frame.right) / 2, frame.bottom + 34}, Anchor::Middle, angle_label(plot.request.view));
  canvas.add(Label{.at = {frame.left - 52, (frame.top + frame.bottom) / 2},
                   .anchor = Anchor::Middle,
                   .runs = rich(value_label(plot)),
                   .size = kTextSize,
                   .colour = kInk,
                   .is_upright = true});
}

}  // namespace

Drawing draw_cartesian(const Plot& plot) {
  Canvas canvas(plot.look.width, plot.look.height, plot.title);
  const std::vector<Trace> traces = traces_of(plot);
  const Layout layout = draw_surroundings(canvas, plot, traces);
  const Rectangle frame{layout.plot.left + 60, layout.plot.top + 6, layout.plot.right - 16, layout.plot.bottom - 36};
  const Scale scale = scale_for(plot.look.scale, shown_numbers(plot), plot.look.maximum);
  const AngleAxis axis = angle_axis(plot.request.view);
  const Placement placement = [&](double angle, double fraction) {
    return Point{frame.left + (angle - axis.low) / (axis.high - axis.low) * frame.width(),
                 frame.bottom - fraction * frame.height()};
  };
  draw_axes(canvas, plot, frame, scale, placement);
  if (plot.request.view == View::ThetaO) {
    const double x = placement(-plot.request.incidence, 0).x;
    canvas.line({x, frame.top}, {x, frame.bottom}, {.colour = kFaint, .dashes = {4, 4}});
    canvas.text({x + 4, frame.top + 12}, Anchor::Start, rich("ω_i"), kTextSize, kFaint);
  }
  for (const Trace& trace : traces) draw_error_band(canvas, trace, scale, placement);
  draw_traces(canvas, traces, scale, placement);
  return canvas.take();
}

Drawing draw_polar(const Plot& plot) {
  Canvas canvas(plot.look.width, plot.look.height, plot.title);
  const std::vector<Trace> traces = traces_of(plot);
  const Layout layout = draw_surroundings(canvas, plot, traces);
  Scale scale = scale_for(plot.look.scale, shown_numbers(plot), plot.look.maximum);
  if (scale.kind == ScaleKind::Linear) scale.low = 0;  // what is negative has no place
  const Point centre{(layout.plot.left + layout.plot.right) / 2, layout.plot.bottom - 40};
  const double radius = std::max(20.0, std::min(layout.plot.width() / 2 - 44, centre.y - layout.plot.top - 22));
  const Placement placement = [&](double angle, double fraction) {
    return Point{centre.x + fraction * radius * sine_of(angle), centre.y - fraction * radius * cosine_of(angle)};
  };
  const Stroke grid{.colour = kGridLines};
  double free_from = -1;
  for (const double tick : scale.ticks) {
    const double fraction = scale.fraction_of(tick).value_or(-1);
    if (fraction < 0) continue;
    const double r = fraction * radius;
    if (r > 0) canvas.polyline(arc(centre, r, 0, 180), grid);
    if (r < free_from) continue;
    canvas.text({centre.x + r, centre.y + 16}, Anchor::Middle, tick_text(scale, tick), kSmallText);
    free_from = r + 36;
  }
  for (const double angle : {-90.0, -60.0, -30.0, 0.0, 30.0, 60.0, 90.0}) {
    canvas.line(centre, placement(angle, 1), grid);
    const Point end = placement(angle, 1 + 10 / radius);
    const Anchor anchor = angle == 0 ? Anchor::Middle : angle < 0 ? Anchor::End : Anchor::Start;
    canvas.text({end.x, end.y + 4}, anchor, plain(degrees_text(angle)), kSmallText);
  }
  canvas.line(placement(-90, 1), placement(90, 1), {.colour = kInk});
  const Point light = placement(-plot.request.incidence, 1);
  canvas.line(centre, light, {.colour = kFaint, .dashes = {4, 4}});
  canvas.circle(light, 4, {0xe6, 0x9f, 0x00});
  canvas.text({light.x - 8, light.y - 8}, Anchor::End, rich("ω_i"), kTextSize, kFaint);
  draw_traces(canvas, traces, scale, placement);
  Runs label = rich(value_label(plot));
  const Runs over = rich(" over θ_o, positive away from the light");
  label.insert(label.end(), over.begin(), over.end());
  canvas.text({centre.x, centre.y + 34}, Anchor::Middle, std::move(label));
  return canvas.take();
}

}  // namespace texbrdf::plots
