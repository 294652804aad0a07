#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "eval/evaluate.h"
#include "plots/plot.h"

namespace texbrdf::plots {

/// One number of a value: a channel, the luminance, or the value itself where it is a real.
struct Component {
  enum class Kind : uint8_t { Red, Green, Blue, Luminance, Value };
  Kind kind = Kind::Value;

  double of(const eval::Triple& value) const;
  /// For the head of a column.
  std::string_view word() const;
};

/// What of each value of the series is shown.
std::vector<Component> components_of(const Plot& plot, const Series& series);

/// All numbers that are shown, of all series; those of errors are added to and taken from theirs.
std::vector<double> shown_numbers(const Plot& plot);

/// Whether there is a value; samples below the horizon have none.
std::optional<double> number_of(const Component& component, const Sample& sample);

}  // namespace texbrdf::plots
