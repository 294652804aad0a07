#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "plots/drawing.h"

namespace texbrdf::plots {

enum class ScaleKind : uint8_t { Linear, Log };

/// The axis of a plot's values: its ends and its ticks, as people would choose them.
struct Scale {
  ScaleKind kind = ScaleKind::Linear;
  double low = 0;  ///< of the axis; exponents of ten where it is logarithmic
  double high = 1;
  std::vector<double> ticks;  ///< values, ascending

  /// Where a value lies between the ends, 0 to 1, or beyond them; nothing where it has no place on the axis.
  std::optional<double> fraction_of(double value) const;
};

/// For all of the values that are finite. From 0 on, and 0 is among the ticks, where it is linear; some decades where
/// it is logarithmic. `maximum` takes the place of the largest value.
Scale scale_for(ScaleKind kind, std::span<const double> values, std::optional<double> maximum);

/// The multiples of 1, 2 or 5 times a power of ten from `low` to `high`, about `count` of them.
std::vector<double> nice_ticks(double low, double high, int count);

/// In digits that tell neighbours apart; as a power of ten where there would be many zeros.
Runs tick_text(const Scale& scale, double value);
/// A number for a legend or a note: four digits.
std::string number_text(double value);

}  // namespace texbrdf::plots
