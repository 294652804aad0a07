#include "plots/cubature.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace texbrdf::plots {
namespace {

using Triple = std::array<double, 3>;

struct Cell {
  double x = 0;  ///< of the middle
  double y = 0;
  double half_width = 0;
  double half_height = 0;
  Integral integral;
  bool is_cut_across_x = false;  ///< where it is halved
  double worst_error = 0;
};

/// A. C. Genz and A. A. Malik, "An adaptive algorithm for numerical integration over an N-dimensional rectangular
/// region", 1980, for two dimensions: rules of degree 7 and 5 on the same points. Weights are parts of the area.
class GenzMalik {
 public:
  explicit GenzMalik(const Integrand& integrand) : integrand_(integrand) {}

  /// Nothing where the integrand gives nothing.
  std::optional<Cell> integrated(Cell cell) {
    has_all_ = true;
    const Triple middle = at(cell, 0, 0);
    const auto [near_x, near_y] = axis_sums(cell, kNear);
    const auto [far_x, far_y] = axis_sums(cell, kFar);
    const Triple far_corners = corner_sum(cell, kFar);
    const Triple near_corners = corner_sum(cell, kCorner);
    if (!has_all_) return std::nullopt;

    const double area = 4 * cell.half_width * cell.half_height;
    double bend_x = 0;
    double bend_y = 0;
    cell.worst_error = 0;
    for (std::size_t c = 0; c < middle.size(); ++c) {
      const double near = near_x[c] + near_y[c];
      const double far = far_x[c] + far_y[c];
      const double seventh = (-3816 * middle[c] + 2940 * near + 1020 * far + 200 * far_corners[c]) / 19683 +
                             6859 * near_corners[c] / (4 * 19683.0);
      const double fifth = (-1942 * middle[c] + 735 * near + 65 * far + 50 * far_corners[c]) / 1458;
      cell.integral.value[c] = area * seventh;
      cell.integral.error[c] = area * kCaution * std::abs(seventh - fifth);
      cell.worst_error = std::max(cell.worst_error, cell.integral.error[c]);
      bend_x += std::abs(fourth_difference(middle[c], near_x[c], far_x[c]));
      bend_y += std::abs(fourth_difference(middle[c], near_y[c], far_y[c]));
    }
    cell.is_cut_across_x = bend_x == bend_y ? cell.half_width >= cell.half_height : bend_x > bend_y;
    return cell;
  }

 private:
  static constexpr double kNear = 0.35856858280031809;    // sqrt(9/70)
  static constexpr double kFar = 0.94868329805051380;     // sqrt(9/10)
  static constexpr double kCorner = 0.68824720161168530;  // sqrt(9/19)

  /// The difference of the rules is about the error of the weaker one, but no bound.
  static constexpr double kCaution = 2;

  static double fourth_difference(double middle, double near, double far) {
    return near - 2 * middle - (far - 2 * middle) / 7;
  }

  Triple at(const Cell& cell, double x, double y) {
    const auto value = integrand_(cell.x + x * cell.half_width, cell.y + y * cell.half_height);
    has_all_ &= value.has_value();
    return value.value_or(Triple{});
  }

  static Triple sum(const Triple& a, const Triple& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

  std::pair<Triple, Triple> axis_sums(const Cell& cell, double offset) {
    return {sum(at(cell, offset, 0), at(cell, -offset, 0)), sum(at(cell, 0, offset), at(cell, 0, -offset))};
  }

  Triple corner_sum(const Cell& cell, double offset) {
    return sum(sum(at(cell, offset, offset), at(cell, -offset, offset)),
               sum(at(cell, offset, -offset), at(cell, -offset, -offset)));
  }

  const Integrand& integrand_;
  bool has_all_ = true;
};

Cell cell_between(double left, double right, double low, double high) {
  Cell cell;
  cell.x = (left + right) / 2;
  cell.y = (low + high) / 2;
  cell.half_width = (right - left) / 2;
  cell.half_height = (high - low) / 2;
  return cell;
}

std::pair<Cell, Cell> halves(const Cell& cell) {
  std::pair<Cell, Cell> both{cell, cell};
  double Cell::* const place = cell.is_cut_across_x ? &Cell::x : &Cell::y;
  double Cell::* const half = cell.is_cut_across_x ? &Cell::half_width : &Cell::half_height;
  const double quarter = cell.*half / 2;
  both.first.*place -= quarter;
  both.second.*place += quarter;
  both.first.*half = both.second.*half = quarter;
  return both;
}

Integral total(std::span<const Cell> cells) {
  Integral sum;
  for (const Cell& cell : cells) {
    for (std::size_t c = 0; c < sum.value.size(); ++c) {
      sum.value[c] += cell.integral.value[c];
      sum.error[c] += cell.integral.error[c];
    }
  }
  return sum;
}

bool is_enough(const Integral& integral, double relative) {
  double largest = 0;
  double error = 0;
  for (std::size_t c = 0; c < integral.value.size(); ++c) {
    largest = std::max(largest, std::abs(integral.value[c]));
    error = std::max(error, integral.error[c]);
  }
  return !(error > relative * largest);  // NaN gets no better
}

constexpr auto kLessWrong = [](const Cell& a, const Cell& b) { return a.worst_error < b.worst_error; };

/// Halves the worst cell until the whole is good enough, or cells or the integrand come to an end.
void refine(std::vector<Cell>& cells, GenzMalik& rule, const Accuracy& accuracy) {
  // A sum over all cells costs more than a few cells: so it is formed now and then.
  constexpr std::size_t kRound = 8;
  while (!is_enough(total(cells), accuracy.relative)) {
    for (std::size_t i = 0; i < kRound; ++i) {
      if (cells.size() >= accuracy.most_cells) return;
      const auto [first, second] = halves(cells.front());
      const std::optional<Cell> one = rule.integrated(first);
      const std::optional<Cell> other = rule.integrated(second);
      if (!one || !other) return;
      std::ranges::pop_heap(cells, kLessWrong);
      cells.back() = *one;
      std::ranges::push_heap(cells, kLessWrong);
      cells.push_back(*other);
      std::ranges::push_heap(cells, kLessWrong);
    }
  }
}

}  // namespace

std::optional<Integral> integrate(const Integrand& integrand, std::span<const double> xs, std::span<const double> ys,
                                  const Accuracy& accuracy) {
  GenzMalik rule(integrand);
  std::vector<Cell> cells;
  for (std::size_t i = 1; i < xs.size(); ++i) {
    for (std::size_t k = 1; k < ys.size(); ++k) {
      const std::optional<Cell> cell = rule.integrated(cell_between(xs[i - 1], xs[i], ys[k - 1], ys[k]));
      if (!cell) return std::nullopt;
      cells.push_back(*cell);
    }
  }
  std::ranges::make_heap(cells, kLessWrong);
  refine(cells, rule, accuracy);
  return total(cells);
}

}  // namespace texbrdf::plots
