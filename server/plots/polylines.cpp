#include "plots/polylines.h"

#include <algorithm>
#include <utility>

namespace texbrdf::plots {
namespace {

struct Place {
  double angle = 0;
  double fraction = 0;
};

bool is_inside(double fraction) {
  constexpr double kRounding = 1e-9;
  return fraction >= -kRounding && fraction <= 1 + kRounding;
}

/// The line between two points where it is between the ends of the axis.
std::optional<std::pair<Place, Place>> clipped(const Place& a, const Place& b) {
  double from = 0;
  double to = 1;
  const double rise = b.fraction - a.fraction;
  if (rise == 0) return is_inside(a.fraction) ? std::optional(std::pair(a, b)) : std::nullopt;
  const double at_low = -a.fraction / rise;
  const double at_high = (1 - a.fraction) / rise;
  from = std::max(from, std::min(at_low, at_high));
  to = std::min(to, std::max(at_low, at_high));
  if (from > to) return std::nullopt;
  const auto at = [&](double part) { return Place{a.angle + (b.angle - a.angle) * part, a.fraction + rise * part}; };
  return std::pair(from == 0 ? a : at(from), to == 1 ? b : at(to));
}

class LineBuilder {
 public:
  explicit LineBuilder(const Placement& placement) : placement_(placement) {}

  void add_segment(const Place& a, const Place& b) {
    const auto segment = clipped(a, b);
    if (!segment) {
      end_line();
      return;
    }
    const auto& [first, second] = *segment;
    if (line_.empty() || first.angle != a.angle) {
      end_line();
      add(first);
    }
    add(second);
    if (second.angle != b.angle) end_line();
  }

  void add_alone(const Place& place) {
    if (!is_inside(place.fraction)) return;
    end_line();
    add(place);
    add(place);
    end_line();
  }

  void end_line() {
    if (!line_.empty()) lines_.push_back(std::exchange(line_, {}));
  }

  std::vector<std::vector<Point>> take() {
    end_line();
    return std::move(lines_);
  }

 private:
  void add(const Place& place) { line_.push_back(placement_(place.angle, std::clamp(place.fraction, 0.0, 1.0))); }

  const Placement& placement_;
  std::vector<Point> line_;
  std::vector<std::vector<Point>> lines_;
};

}  // namespace

std::vector<std::vector<Point>> lines_through(const Curve& curve, const Component& component, const Scale& scale,
                                              const Placement& placement) {
  std::vector<std::optional<Place>> places;
  for (std::size_t i = 0; i < curve.angles.size(); ++i) {
    const std::optional<double> number = number_of(component, curve.values[i]);
    const std::optional<double> fraction = number ? scale.fraction_of(*number) : std::nullopt;
    places.push_back(fraction ? std::optional(Place{curve.angles[i], *fraction}) : std::nullopt);
  }
  LineBuilder lines(placement);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool has_left = i > 0 && places[i - 1];
    const bool has_right = i + 1 < places.size() && places[i + 1];
    if (places[i] && has_left) lines.add_segment(*places[i - 1], *places[i]);
    if (places[i] && !has_left && !has_right) lines.add_alone(*places[i]);
    if (!places[i]) lines.end_line();
  }
  return lines.take();
}

}  // namespace texbrdf::plots
