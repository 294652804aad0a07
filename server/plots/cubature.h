#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace texbrdf::plots {

/// Three integrals at once, of the channels of a colour.
using Integrand = std::function<std::optional<std::array<double, 3>>(double x, double y)>;

struct Integral {
  std::array<double, 3> value{};
  std::array<double, 3> error{};  ///< an estimate of how far the value may be off
};

struct Accuracy {
  double relative = 1e-6;      ///< of the largest channel: enough
  std::size_t most_cells = 0;  ///< of the rectangles that the domain is cut into, at least those at the beginning
};

/// Over the rectangle from the first to the last of `xs` and `ys` (ascending), which is cut there to begin with and
/// then where the error is largest. Nothing where the integrand gives nothing at first; where it does so later, what
/// was found until then.
std::optional<Integral> integrate(const Integrand& integrand, std::span<const double> xs, std::span<const double> ys,
                                  const Accuracy& accuracy);

/// How often the integrand is asked for a rectangle.
inline constexpr std::size_t kPointsOfCell = 17;

}  // namespace texbrdf::plots
