#include "plots/channels.h"

#include <array>

namespace texbrdf::plots {
namespace {

/// Of linear sRGB (ITU-R BT.709).
constexpr eval::Triple kLuminance = {0.2126, 0.7152, 0.0722};

/// Three surfaces in each other and pictures of a single number are harder to read.
Channels usual_channels(View view) {
  return view == View::Lobe ? Channels::Luminance : Channels::All;
}

}  // namespace

double Component::of(const eval::Triple& value) const {
  switch (kind) {
    case Kind::Red:
    case Kind::Value:
      return value[0];
    case Kind::Green:
      return value[1];
    case Kind::Blue:
      return value[2];
    case Kind::Luminance:
      return kLuminance[0] * value[0] + kLuminance[1] * value[1] + kLuminance[2] * value[2];
  }
  return 0;
}

std::string_view Component::word() const {
  switch (kind) {
    case Kind::Red:
      return "red";
    case Kind::Green:
      return "green";
    case Kind::Blue:
      return "blue";
    case Kind::Luminance:
      return "luminance";
    case Kind::Value:
      return "value";
  }
  return "";
}

std::vector<Component> components_of(const Plot& plot, const Series& series) {
  using Kind = Component::Kind;
  if (!series.is_colour) return {{Kind::Value}};
  switch (plot.look.channels.value_or(usual_channels(plot.request.view))) {
    case Channels::Red:
      return {{Kind::Red}};
    case Channels::Green:
      return {{Kind::Green}};
    case Channels::Blue:
      return {{Kind::Blue}};
    case Channels::All:
      return {{Kind::Red}, {Kind::Green}, {Kind::Blue}};
    case Channels::Luminance:
      return {{Kind::Luminance}};
  }
  return {};
}

std::optional<double> number_of(const Component& component, const Sample& sample) {
  if (!sample) return std::nullopt;
  return component.of(*sample);
}

std::vector<double> shown_numbers(const Plot& plot) {
  std::vector<double> numbers;
  for (const Series& series : plot.series) {
    const auto* const curve = std::get_if<Curve>(&series.samples);
    const std::vector<Sample>& values = curve != nullptr ? curve->values : std::get<Grid>(series.samples).values;
    for (const Component& component : components_of(plot, series)) {
      for (std::size_t i = 0; i < values.size(); ++i) {
        const std::optional<double> number = number_of(component, values[i]);
        if (!number) continue;
        numbers.push_back(*number);
        if (curve != nullptr && !curve->errors.empty()) numbers.push_back(*number + component.of(curve->errors[i]));
      }
    }
  }
  return numbers;
}

}  // namespace texbrdf::plots
