#include "plots/draw_lobe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "plots/canvas.h"
#include "plots/directions.h"
#include "plots/legend.h"

namespace texbrdf::plots {
namespace {

using Vector = eval::Triple;

constexpr double kAmbient = 0.4;
constexpr double kDarkerEdges = 0.86;
constexpr double kLabelRoom = 40;
constexpr double kAxisLength = 1.08;  ///< of the largest radius

Vector minus(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector scaled(const Vector& v, double factor) {
  return {v[0] * factor, v[1] * factor, v[2] * factor};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Colour shaded(Colour colour, double light) {
  const auto channel = [&](uint8_t value) { return static_cast<uint8_t>(std::lround(value * light)); };
  return {channel(colour.red), channel(colour.green), channel(colour.blue), colour.opacity};
}

/// Where things of the surface's frame are on the picture. The largest radius is 1.
class Eye {
 public:
  Eye(double azimuth, double elevation)
      : right_{-sine_of(azimuth), cosine_of(azimuth), 0},
        towards_{direction(90 - elevation, azimuth)},
        up_{cross(towards_, right_)} {}

  void place(Point origin, double radius) {
    origin_ = origin;
    radius_ = radius;
  }

  Point at(const Vector& v) const { return {origin_.x + radius_ * dot(v, right_), origin_.y - radius_ * dot(v, up_)}; }
  double nearness(const Vector& v) const { return dot(v, towards_); }
  /// What of a face with this normal the eye's lamp lights, from either side.
  double light_on(const Vector& normal) const {
    const auto part = [&](std::size_t i) { return towards_[i] + 0.3 * up_[i] - 0.3 * right_[i]; };
    const Vector lamp = {part(0), part(1), part(2)};
    const double length = std::sqrt(dot(normal, normal) * dot(lamp, lamp));
    return length == 0 ? 1 : kAmbient + (1 - kAmbient) * std::abs(dot(normal, lamp)) / length;
  }

 private:
  Vector right_;
  Vector towards_;
  Vector up_;
  Point origin_;
  double radius_ = 1;
};

/// A part of the picture with its place in the order from behind.
struct Piece {
  double nearness = 0;
  Path path;
};

class LobeDrawing {
 public:
  explicit LobeDrawing(const Plot& plot)
      : plot_(plot),
        canvas_(plot.look.width, plot.look.height, plot.title),
        scale_(scale_for(plot.look.scale, shown_numbers(plot), plot.look.maximum)),
        eye_(plot.request.phi + 180 + plot.look.azimuth, plot.look.elevation) {
    if (scale_.kind == ScaleKind::Linear) scale_.low = 0;
  }

  Drawing draw() {
    const std::vector<Trace> traces = traces_of(plot_);
    const Layout layout = draw_surroundings(canvas_, plot_, traces);
    place_eye(layout);
    draw_ground();
    for (const Trace& trace : traces) add_surface(trace, traces.size() > 1);
    add_axes();
    add_light();
    draw_labels();  // the surface hides those that are behind it
    draw_pieces();
    canvas_.text({(layout.plot.left + layout.plot.right) / 2, layout.plot.bottom}, Anchor::Middle,
                 rich("distance from the origin: " + value_label(plot_)));
    return canvas_.take();
  }

 private:
  /// The ground is a circle seen at a slant, with the normal's axis above it.
  void place_eye(const Layout& layout) {
    const double ground = sine_of(plot_.look.elevation);
    const double above = std::max(cosine_of(plot_.look.elevation) * kAxisLength, ground);
    const double height = layout.plot.height() - kLabelRoom;
    const double radius =
        std::max(10.0, std::min((layout.plot.width() / 2 - kLabelRoom) / kAxisLength, height / (above + ground + 0.1)));
    const double spare = height - radius * (above + ground);
    eye_.place({(layout.plot.left + layout.plot.right) / 2, layout.plot.top + spare / 2 + radius * above}, radius);
  }

  void draw_ground() {
    canvas_.add(Path{.lines = {circle(1)},
                     .is_closed = true,
                     .fill = Colour{0xf4, 0xf4, 0xf4},
                     .stroke = Stroke{.colour = {0xbb, 0xbb, 0xbb}}});
    for (const double tick : scale_.ticks) {
      const double radius = scale_.fraction_of(tick).value_or(0);
      if (radius <= 0 || radius >= 1) continue;
      canvas_.add(Path{.lines = {circle(radius)}, .is_closed = true, .stroke = Stroke{.colour = kGridLines}});
    }
  }

  std::vector<Point> circle(double radius) const {
    constexpr int kParts = 120;
    std::vector<Point> points;
    for (int i = 0; i < kParts; ++i) points.push_back(eye_.at(scaled(direction(90, i * 360.0 / kParts), radius)));
    return points;
  }

  /// Nothing where there is no value, or one that has no place.
  std::optional<Vector> vertex(const Grid& grid, const Component& component, std::size_t row,
                               std::size_t column) const {
    const std::optional<double> number = number_of(component, grid.values[row * grid.columns.size() + column]);
    const std::optional<double> fraction = number ? scale_.fraction_of(*number) : std::nullopt;
    const bool is_low_log = scale_.kind == ScaleKind::Log && number && *number > 0;
    if (!fraction || (*fraction < 0 && !is_low_log)) return std::nullopt;
    return scaled(direction(grid.rows[row], grid.columns[column]), std::clamp(*fraction, 0.0, 1.0));
  }

  void add_surface(const Trace& trace, bool is_one_of_several) {
    const Grid& grid = std::get<Grid>(trace.series->samples);
    Colour colour = trace.stroke.colour;
    if (is_one_of_several) colour.opacity = 0.7;
    for (std::size_t row = 1; row < grid.rows.size(); ++row) {
      for (std::size_t column = 1; column < grid.columns.size(); ++column) {
        const std::array corners = {
            vertex(grid, trace.component, row - 1, column - 1), vertex(grid, trace.component, row - 1, column),
            vertex(grid, trace.component, row, column), vertex(grid, trace.component, row, column - 1)};
        if (std::ranges::all_of(corners, [](const auto& corner) { return corner.has_value(); })) {
          add_face({*corners[0], *corners[1], *corners[2], *corners[3]}, colour);
        }
      }
    }
  }

  void add_face(const std::array<Vector, 4>& corners, const Colour& colour) {
    const Vector normal = cross(minus(corners[2], corners[0]), minus(corners[3], corners[1]));
    const double light = eye_.light_on(normal);
    Piece piece;
    piece.path.is_closed = true;
    piece.path.fill = shaded(colour, light);
    Colour edge = shaded(colour, light * kDarkerEdges);
    piece.path.stroke = Stroke{.colour = edge, .width = 0.4};
    std::vector<Point> outline;
    for (const Vector& corner : corners) {
      outline.push_back(eye_.at(corner));
      piece.nearness += eye_.nearness(corner) / 4;
    }
    piece.path.lines = {std::move(outline)};
    pieces_.push_back(std::move(piece));
  }

  /// In short parts, so that the surface hides those behind it.
  void add_line(const Vector& from, const Vector& to, const Stroke& stroke, bool is_dashed = false) {
    constexpr int kParts = 60;
    const Vector along = minus(to, from);
    const auto at = [&](int i) {
      const double part = static_cast<double>(i) / kParts;
      return Vector{from[0] + along[0] * part, from[1] + along[1] * part, from[2] + along[2] * part};
    };
    for (int i = 0; i < kParts; ++i) {
      if (is_dashed && i % 2 == 1) continue;
      Piece piece;
      piece.nearness = (eye_.nearness(at(i)) + eye_.nearness(at(i + 1))) / 2;
      piece.path.lines = {{eye_.at(at(i)), eye_.at(at(i + 1))}};
      piece.path.stroke = stroke;
      pieces_.push_back(std::move(piece));
    }
  }

  void add_axes() {
    const Stroke axis{.colour = kInk};
    for (const Vector& end : axis_ends()) add_line({0, 0, 0}, end, axis);
  }

  void add_light() {
    const Vector light = direction(plot_.request.incidence, plot_.request.phi);
    const Vector mirrored = {-light[0], -light[1], light[2]};
    add_line(scaled(light, kAxisLength), {0, 0, 0}, {.colour = {0xe6, 0x9f, 0x00}, .width = 2});
    add_line({0, 0, 0}, scaled(mirrored, kAxisLength), {.colour = {0xe6, 0x9f, 0x00}, .width = 1.2}, true);
  }

  void draw_pieces() {
    std::ranges::stable_sort(pieces_, {}, &Piece::nearness);
    for (Piece& piece : pieces_) canvas_.add(std::move(piece.path));
  }

  void draw_labels() {
    constexpr std::array kNames = {"X", "Y", "n"};
    const auto ends = axis_ends();
    for (std::size_t i = 0; i < ends.size(); ++i) label_at(ends[i], plain(kNames[i]), kInk);
    label_at(scaled(direction(plot_.request.incidence, plot_.request.phi), kAxisLength), rich("ω_i"),
             {0x9a, 0x6a, 0x00});
    // Beside the light's plane, on the eye's side, where few lobes are.
    const Vector along = direction(90, azimuth() - 60);
    double free_from = 0;
    for (const double tick : scale_.ticks) {
      const double radius = scale_.fraction_of(tick).value_or(0);
      const Point at = eye_.at(scaled(along, radius));
      const double distance = std::hypot(at.x - eye_.at({}).x, at.y - eye_.at({}).y);
      if (radius <= 0 || radius > 1.001 || distance < free_from) continue;
      canvas_.text({at.x, at.y + 4}, Anchor::Middle, tick_text(scale_, tick), kSmallText);
      free_from = distance + 2 * kSmallText;
    }
  }

  void label_at(const Vector& end, Runs runs, Colour colour) {
    const Point at = eye_.at(scaled(end, 1.06));
    canvas_.text({at.x, at.y + 4}, Anchor::Middle, std::move(runs), kTextSize, colour);
  }

  double azimuth() const { return plot_.request.phi + 180 + plot_.look.azimuth; }

  static std::array<Vector, 3> axis_ends() { return {{{kAxisLength, 0, 0}, {0, kAxisLength, 0}, {0, 0, kAxisLength}}}; }

  const Plot& plot_;
  Canvas canvas_;
  Scale scale_;
  Eye eye_;
  std::vector<Piece> pieces_;
};

}  // namespace

Drawing draw_lobe(const Plot& plot) {
  return LobeDrawing(plot).draw();
}

}  // namespace texbrdf::plots
