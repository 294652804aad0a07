#include "scene_json/property_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "source/trimmed.h"

namespace texbrdf::scene_json {
namespace {

using scene::PropertyType;

constexpr double kLargest = std::numeric_limits<float>::max();
constexpr double kLargestInt = std::numeric_limits<int32_t>::max();

std::optional<double> read_number(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || !(std::abs(number) <= kLargest)) return std::nullopt;
  return number;
}

/// What stands in `[…]` at the front, which is taken away; nothing where no bracket stands there.
std::optional<std::string_view> take_bracket(std::string_view& text) {
  text = trimmed(text);
  const std::size_t close = text.find(']');
  if (!text.starts_with('[') || close == std::string_view::npos) return std::nullopt;
  const std::string_view inside = trimmed(text.substr(1, close - 1));
  text = trimmed(text.substr(close + 1));
  return inside;
}

Result<scene::PropertyRange> read_range(std::string_view text) {
  constexpr std::string_view kWord = "Range";
  const auto numbers = text.starts_with(kWord) ? read_tuple(text.substr(kWord.size())) : std::nullopt;
  if (!numbers || numbers->size() != 2) return Failure{fmt::format("`[{}]` is no `[Range(least, greatest)]`", text)};
  const scene::PropertyRange range{(*numbers)[0], (*numbers)[1]};
  if (range.least > range.greatest)
    return Failure{fmt::format("the range from {} to {} is empty", range.least, range.greatest)};
  return range;
}

scene::Triple default_of(const scene::Property& property) {
  scene::Triple value{};
  if (!property.range) return value;
  value.fill(std::clamp(0.0, property.range->least, property.range->greatest));
  return value;
}

}  // namespace

bool is_identifier(std::string_view text) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return !text.empty() && is_letter(text.front()) &&
         std::ranges::all_of(text, [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); });
}

std::optional<std::vector<double>> read_tuple(std::string_view text) {
  text = trimmed(text);
  const bool has_brackets = text.starts_with('(') && text.ends_with(')') && text.size() >= 2;
  if (has_brackets) text = text.substr(1, text.size() - 2);
  std::vector<double> numbers;
  while (true) {
    const std::string_view word = text.substr(0, text.find(','));
    const std::optional<double> number = read_number(word);
    if (!number || (!has_brackets && word.size() != text.size())) return std::nullopt;
    numbers.push_back(*number);
    if (word.size() == text.size()) return numbers;
    text.remove_prefix(word.size() + 1);
  }
}

Result<scene::Triple> value_of(const std::vector<double>& numbers, PropertyType type) {
  const std::size_t wanted = component_count(type);
  if (numbers.size() != wanted) {
    return Failure{fmt::format("a {} has {} number{}, here {} {}", property_type_name(type), wanted,
                               wanted == 1 ? "" : "s", numbers.size() == 1 ? "is" : "are", numbers.size())};
  }
  scene::Triple value{};
  for (std::size_t i = 0; i < wanted; ++i) {
    if (is_integer(type) && (numbers[i] != std::trunc(numbers[i]) || std::abs(numbers[i]) > kLargestInt)) {
      return Failure{fmt::format("{} is no whole number of 32 bits, as {} has", numbers[i], property_type_name(type))};
    }
    value[i] = numbers[i];
  }
  return value;
}

Result<scene::Property> read_property(std::string_view text) {
  scene::Property property;
  const auto type_name = take_bracket(text);
  if (!type_name) return Failure{"a property is written `[float] [Range(0, 1)] _Name`: its type in brackets first"};
  const auto type = scene::find_property_type(*type_name);
  if (!type)
    return Failure{
        fmt::format("`{}` is no type: there are {}", *type_name, fmt::join(scene::property_type_names(), ", "))};
  property.type = *type;
  if (text.starts_with('[')) {
    const auto inside = take_bracket(text);
    if (!inside) return Failure{"a bracket is not closed"};
    const Result<scene::PropertyRange> range = read_range(*inside);
    if (!range) return Failure{range.error()};
    property.range = *range;
  }
  const std::size_t equals = text.find('=');
  property.name = std::string(trimmed(text.substr(0, equals)));
  if (!is_identifier(property.name)) return Failure{fmt::format("`{}` is no name of a property", property.name)};
  property.default_value = default_of(property);
  if (equals == std::string_view::npos) return property;
  const auto numbers = read_tuple(text.substr(equals + 1));
  if (!numbers) return Failure{fmt::format("`{}` is no value", trimmed(text.substr(equals + 1)))};
  const Result<scene::Triple> value = value_of(*numbers, property.type);
  if (!value) return Failure{value.error()};
  property.default_value = *value;
  return property;
}

}  // namespace texbrdf::scene_json
