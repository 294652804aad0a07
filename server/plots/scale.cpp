#include "plots/scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace texbrdf::plots {
namespace {

constexpr int kSomeTicks = 5;
constexpr int kMostDecades = 8;
constexpr double kLargest = 1e300;
constexpr double kSmallest = 1e-300;
/// Of a step: so near is as good as at a tick.
constexpr double kNear = 1e-9;

double nice_step(double at_least) {
  const double power = std::pow(10, std::floor(std::log10(at_least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= at_least * (1 - kNear)) return factor * power;
  }
  return 10 * power;
}

std::vector<double> multiples(double first, double last, double step) {
  std::vector<double> ticks;
  for (double i = first; i <= last; ++i) ticks.push_back(i * step);
  return ticks;
}

Scale linear_scale(double least, double most) {
  least = std::max(std::min(least, 0.0), -kLargest);
  most = std::min(std::max(most, 0.0), kLargest);
  if (most - least < kSmallest) return {ScaleKind::Linear, 0, 1, {0, 0.5, 1}};
  const double step = nice_step((most - least) / kSomeTicks);
  const double first = std::floor(least / step + kNear);
  const double last = std::ceil(most / step - kNear);
  return {ScaleKind::Linear, first * step, last * step, multiples(first, last, step)};
}

Scale log_scale(double least, double most) {
  if (!(most >= kSmallest)) return {ScaleKind::Log, -1, 0, {0.1, 1}};
  const double high = std::ceil(std::log10(std::min(most, kLargest)) - kNear);
  const double low = std::min(std::max(std::floor(std::log10(least) + kNear), high - kMostDecades), high - 1);
  Scale scale{ScaleKind::Log, low, high, {}};
  const double decades = std::ceil((high - low) / kSomeTicks);
  for (double exponent = high; exponent >= low; exponent -= decades) scale.ticks.push_back(std::pow(10, exponent));
  std::ranges::reverse(scale.ticks);
  return scale;
}

std::string with_minus_sign(std::string text) {
  if (text.starts_with('-')) text.replace(0, 1, "−");
  return text;
}

Runs power_of_ten(double value) {
  const double exponent = std::floor(std::log10(std::abs(value)) + kNear);
  const double mantissa = value / std::pow(10, exponent);
  const std::string digits = fmt::format("{:.3g}", mantissa);
  Runs runs = plain(digits == "1" ? "10" : with_minus_sign(digits) + "·10");
  runs.push_back({.text = with_minus_sign(fmt::format("{}", exponent)), .script = Script::Super});
  return runs;
}

}  // namespace

std::optional<double> Scale::fraction_of(double value) const {
  if (!std::isfinite(value) || (kind == ScaleKind::Log && value <= 0)) return std::nullopt;
  const double place = kind == ScaleKind::Log ? std::log10(value) : value;
  const double fraction = (place - low) / (high - low);
  return std::isfinite(fraction) ? std::optional(fraction) : std::nullopt;
}

Scale scale_for(ScaleKind kind, std::span<const double> values, std::optional<double> maximum) {
  const bool is_log = kind == ScaleKind::Log;
  double least = is_log ? std::numeric_limits<double>::infinity() : 0;
  double most = 0;
  for (const double value : values) {
    if (!std::isfinite(value) || (is_log && value < kSmallest)) continue;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  if (maximum) most = *maximum;
  return is_log ? log_scale(std::min(least, most), most) : linear_scale(least, most);
}

std::vector<double> nice_ticks(double low, double high, int count) {
  const double step = nice_step((high - low) / count);
  return multiples(std::ceil(low / step - kNear), std::floor(high / step + kNear), step);
}

Runs tick_text(const Scale& scale, double value) {
  constexpr double kMostZeros = 1e5;
  if (value == 0) return plain("0");
  const double size = std::abs(value);
  const bool has_few_zeros =
      scale.kind == ScaleKind::Log ? size > 5e-3 && size < 5e2 : size >= 1e-3 && size < kMostZeros;
  return has_few_zeros ? plain(with_minus_sign(fmt::format("{:.6g}", value))) : power_of_ten(value);
}

std::string number_text(double value) {
  return with_minus_sign(fmt::format("{:.4g}", value));
}

}  // namespace texbrdf::plots
