#include "lighting/environment.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>
#include <utility>

namespace texbrdf::lighting {

namespace {

constexpr double kPi = std::numbers::pi;

/// The height over the horizon plane where a row begins.
double height_of_row(uint32_t row, uint32_t rows) {
  return std::cos(kPi * row / rows);
}

/// Of one texel of the row, in steradians.
double solid_angle(const EnvironmentMap& map, uint32_t row) {
  return (height_of_row(row, map.height) - height_of_row(row + 1, map.height)) * 2 * kPi / map.width;
}

/// A choice among the entries of a list of growing sums that ends with 1.
struct Choice {
  std::size_t place;
  double rest;  ///< where between the entry before and this one, [0, 1)
};

template <typename Number>
Choice choose(std::span<const Number> sums, double random) {
  const auto below_all = std::min(static_cast<Number>(random), std::nextafter(Number{1}, Number{0}));
  const auto found = std::ranges::upper_bound(sums, below_all);
  const auto place = std::min<std::size_t>(static_cast<std::size_t>(found - sums.begin()), sums.size() - 1);
  const double before = place > 0 ? static_cast<double>(sums[place - 1]) : 0;
  const double rest = (random - before) / (static_cast<double>(sums[place]) - before);
  return {place, std::clamp(rest, 0.0, std::nextafter(1.0, 0.0))};
}

/// By its height over the horizon plane, and how far around it is in the picture.
glm::dvec3 direction_of(double height, double part) {
  const double around = (part - 0.5) * 2 * kPi;
  const double radius = std::sqrt(std::max(0.0, 1 - height * height));
  return {radius * std::sin(around), height, -radius * std::cos(around)};
}

}  // namespace

glm::dvec3 direction_at(const glm::dvec2& place) {
  return direction_of(std::cos(kPi * place.y), place.x);
}

double luminance(const glm::dvec3& colour) {
  return 0.2126 * colour.x + 0.7152 * colour.y + 0.0722 * colour.z;
}

Environment::Environment(EnvironmentMap map) : map_(std::move(map)) {
  columns_.reserve(map_.radiance.size());
  for (uint32_t row = 0; row < map_.height; ++row) {
    const auto texels = std::span(map_.radiance).subspan(std::size_t{row} * map_.width, map_.width);
    double whole = 0;
    for (const glm::vec3& texel : texels) whole += luminance(texel);
    double sum = 0;
    for (const glm::vec3& texel : texels) {
      sum += luminance(texel);
      columns_.push_back(whole > 0 ? static_cast<float>(sum / whole) : 1.0F);
    }
    total_ += whole * solid_angle(map_, row);
    rows_.push_back(total_);
  }
  for (double& row : rows_) row /= total_;
  const double first = luminance(map_.radiance.front());
  is_uniform_ = std::ranges::all_of(map_.radiance, [first](const glm::vec3& c) { return luminance(c) == first; });
}

Environment Environment::furnace() {
  return Environment({1, 1, {glm::vec3(1)}});
}

std::size_t Environment::texel_of(const glm::dvec3& direction) const {
  const double row = std::acos(std::clamp(direction.y, -1.0, 1.0)) / kPi * map_.height;
  const double column = (0.5 + std::atan2(direction.x, -direction.z) / (2 * kPi)) * map_.width;
  const auto at = [](double place, uint32_t count) {
    return static_cast<std::size_t>(std::clamp(std::floor(place), 0.0, count - 1.0));
  };
  return at(row, map_.height) * map_.width + at(column, map_.width);
}

double Environment::density(const glm::dvec3& direction) const {
  return luminance(radiance(direction)) / total_;
}

glm::dvec3 Environment::sample(const glm::dvec2& random) const {
  const Choice row = choose<double>(rows_, random.y);
  const auto columns = std::span<const float>(columns_).subspan(row.place * map_.width, map_.width);
  const Choice column = choose<float>(columns, random.x);
  const auto number = static_cast<uint32_t>(row.place);
  const double high = height_of_row(number, map_.height);
  const double low = height_of_row(number + 1, map_.height);
  return direction_of(high + (low - high) * row.rest, (static_cast<double>(column.place) + column.rest) / map_.width);
}

}  // namespace texbrdf::lighting
