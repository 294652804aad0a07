#pragma once

#include <cmath>
#include <limits>

#include "eval/limits.h"

/// The operations whose meaning differs from that of the C library, in double precision.
namespace texbrdf::eval {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// NaN if either is NaN; of +0 and −0 the first.
inline double minimum(double a, double b) {
  return std::isnan(b) || b < a ? b : a;
}

inline double maximum(double a, double b) {
  return std::isnan(b) || b > a ? b : a;
}

inline double clamp(double x, double low, double high) {
  return minimum(maximum(x, low), high);
}

inline bool is_integer(double x) {
  return std::isfinite(x) && std::trunc(x) == x;
}

inline bool is_odd(double x) {
  return is_integer(x) && std::fmod(x, 2) != 0;
}

/// x^y. A negative x needs an integer y, whose repeated multiplication gives the sign. x^0 is 1 for every x. A zero
/// counts as positive, whatever its sign bit: to a negative power it is +infinity. A NaN exponent gives NaN.
inline double power(double x, double y) {
  if (std::isnan(y) || (x < 0 && !is_integer(y))) return kNan;
  const double magnitude = std::pow(std::fabs(x), y);
  return x < 0 && is_odd(y) ? -magnitude : magnitude;
}

/// The real n-th root, x^(1/n). A negative x needs an odd integer n. NaN for n = 0.
inline double root(double x, double n) {
  if (n == 0 || std::isnan(n) || (x < 0 && !is_odd(n))) return kNan;
  const double magnitude = n == 2 ? std::sqrt(std::fabs(x)) : std::pow(std::fabs(x), 1 / n);
  return x < 0 ? -magnitude : magnitude;
}

inline double into_arc_domain(double x) {
  return std::fabs(x) <= 1 + kArcTolerance ? clamp(x, -1, 1) : x;
}

inline double arccos(double x) {
  return std::acos(into_arc_domain(x));
}

inline double arcsin(double x) {
  return std::asin(into_arc_domain(x));
}

/// In (−π, π], 0 where both are 0. Adding 0 turns −0 into +0, on which the C library's result would depend.
inline double arctan2(double y, double x) {
  return std::atan2(y + 0.0, x + 0.0);
}

}  // namespace texbrdf::eval
