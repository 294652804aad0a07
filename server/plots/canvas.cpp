#include "plots/canvas.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plots/directions.h"

namespace texbrdf::plots {
namespace {

/// What is in the middle of something stays this far inside the picture.
constexpr double kEdge = 4;

}  // namespace

Canvas::Canvas(uint32_t width, uint32_t height, std::string title) {
  drawing_.width = width;
  drawing_.height = height;
  drawing_.title = std::move(title);
}

void Canvas::line(Point from, Point to, const Stroke& stroke) {
  polyline({from, to}, stroke);
}

void Canvas::polyline(std::vector<Point> points, const Stroke& stroke) {
  add(Path{.lines = {std::move(points)}, .stroke = stroke});
}

void Canvas::circle(Point centre, double radius, Colour fill) {
  std::vector<Point> points = arc(centre, radius, 0, 360);
  points.pop_back();
  add(Path{.lines = {std::move(points)}, .is_closed = true, .fill = fill});
}

void Canvas::text(Point at, Anchor anchor, Runs runs, double size, Colour colour) {
  if (anchor == Anchor::Middle) {
    const double half = font_.width_of(runs, size) / 2;
    at.x = std::max(std::min(at.x, width() - half - kEdge), half + kEdge);
  }
  add(Label{.at = at, .anchor = anchor, .runs = std::move(runs), .size = size, .colour = colour});
}

std::vector<Point> arc(Point centre, double radius, double from, double to) {
  // Chords whose middle is a twentieth of a pixel beside the circle.
  constexpr double kStray = 0.05;
  const double widest = radius > kStray ? 2 * std::acos(1 - kStray / radius) * 180 / std::numbers::pi : 90;
  const int count = static_cast<int>(std::ceil(std::abs(to - from) / widest)) + 2;
  std::vector<Point> points;
  for (int i = 0; i <= count; ++i) {
    const double degrees = from + (to - from) * i / count;
    points.push_back({centre.x + radius * cosine_of(degrees), centre.y - radius * sine_of(degrees)});
  }
  return points;
}

}  // namespace texbrdf::plots
