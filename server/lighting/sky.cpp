#include "lighting/sky.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

namespace texbrdf::lighting {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr uint32_t kWidth = 512;
constexpr uint32_t kHeight = kWidth / 2;
constexpr double kGroundReflectance = 0.2;

/// A coefficient of Perez's formula: slope · turbidity + constant.
struct Linear {
  double slope;
  double constant;
  double at(double turbidity) const { return slope * turbidity + constant; }
};

/// A to E of one of x, y and Y, as in the table of the paper.
using PerezTable = std::array<Linear, 5>;
constexpr PerezTable kLuminance{
    {{0.1787, -1.4630}, {-0.3554, 0.4275}, {-0.0227, 5.3251}, {0.1206, -2.5771}, {-0.0670, 0.3703}}};
constexpr PerezTable kChromaX{
    {{-0.0193, -0.2592}, {-0.0665, 0.0008}, {-0.0004, 0.2125}, {-0.0641, -0.8989}, {-0.0033, 0.0452}}};
constexpr PerezTable kChromaY{
    {{-0.0167, -0.2608}, {-0.0950, 0.0092}, {-0.0079, 0.2102}, {-0.0441, -1.6537}, {-0.0109, 0.0529}}};

/// Rows for T², T and 1; columns for θ³, θ², θ and 1, where θ is the sun's angle from the zenith.
using ZenithTable = std::array<std::array<double, 4>, 3>;
constexpr ZenithTable kZenithX{
    {{0.00166, -0.00375, 0.00209, 0}, {-0.02903, 0.06377, -0.03202, 0.00394}, {0.11693, -0.21196, 0.06052, 0.25886}}};
constexpr ZenithTable kZenithY{
    {{0.00275, -0.00610, 0.00317, 0}, {-0.04214, 0.08970, -0.04153, 0.00516}, {0.15346, -0.26756, 0.06670, 0.26688}}};

double zenith_chroma(const ZenithTable& table, double turbidity, double sun) {
  double sum = 0;
  for (const auto& row : table) sum = sum * turbidity + ((row[0] * sun + row[1]) * sun + row[2]) * sun + row[3];
  return sum;
}

/// In kcd/m².
double zenith_luminance(double turbidity, double sun) {
  const double chi = (4.0 / 9 - turbidity / 120) * (kPi - 2 * sun);
  return (4.0453 * turbidity - 4.9710) * std::tan(chi) - 0.2155 * turbidity + 2.4192;
}

/// One of x, y and Y over the sky.
class Distribution {
 public:
  Distribution(const PerezTable& table, double turbidity, double sun, double zenith) {
    std::ranges::transform(table, factors_.begin(), [turbidity](const Linear& entry) { return entry.at(turbidity); });
    scale_ = zenith / perez(1, sun);
  }

  /// `height` over the horizon plane, above 0; `from_sun` in radians.
  double at(double height, double from_sun) const { return scale_ * perez(height, from_sun); }

 private:
  double perez(double height, double from_sun) const {
    const auto& [a, b, c, d, e] = factors_;
    const double cosine = std::cos(from_sun);
    return (1 + a * std::exp(b / height)) * (1 + c * std::exp(d * from_sun) + e * cosine * cosine);
  }

  std::array<double, 5> factors_{};
  double scale_ = 0;
};

/// Linear sRGB (IEC 61966-2-1) of a colour by its chromaticity and luminance; what lies outside is cut off.
glm::dvec3 rgb_of(double x, double y, double luminance) {
  const glm::dvec3 xyz = glm::dvec3(x, y, 1 - x - y) * (luminance / y);
  const glm::dvec3 rgb(3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z,
                       -0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z,
                       0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z);
  return glm::max(rgb, glm::dvec3(0));
}

class SkyColours {
 public:
  explicit SkyColours(const Sky& sky)
      : sun_(kPi / 2 - glm::radians(sky.elevation)),
        towards_sun_(std::sin(sun_) * std::sin(glm::radians(sky.azimuth)), std::cos(sun_),
                     std::sin(sun_) * std::cos(glm::radians(sky.azimuth))),
        x_(kChromaX, sky.turbidity, sun_, zenith_chroma(kZenithX, sky.turbidity, sun_)),
        y_(kChromaY, sky.turbidity, sun_, zenith_chroma(kZenithY, sky.turbidity, sun_)),
        luminance_(kLuminance, sky.turbidity, sun_, zenith_luminance(sky.turbidity, sun_)) {}

  /// `direction` is above the horizon.
  glm::dvec3 at(const glm::dvec3& direction) const {
    const double from_sun = std::acos(std::clamp(glm::dot(direction, towards_sun_), -1.0, 1.0));
    const double height = direction.y;
    return rgb_of(x_.at(height, from_sun), y_.at(height, from_sun), luminance_.at(height, from_sun));
  }

 private:
  double sun_;
  glm::dvec3 towards_sun_;
  Distribution x_;
  Distribution y_;
  Distribution luminance_;
};

/// On level ground, of the upper half of the map.
double irradiance(const std::vector<glm::dvec3>& upper) {
  double sum = 0;
  for (uint32_t row = 0; row < kHeight / 2; ++row) {
    const double high = std::cos(kPi * row / kHeight);
    const double low = std::cos(kPi * (row + 1) / kHeight);
    double whole = 0;
    for (uint32_t column = 0; column < kWidth; ++column) whole += luminance(upper[std::size_t{row} * kWidth + column]);
    sum += whole * (high * high - low * low) / 2 * (2 * kPi / kWidth);
  }
  return sum;
}

}  // namespace

std::optional<std::string> find_fault(const Sky& sky) {
  if (!(sky.elevation >= 0 && sky.elevation <= 90)) {
    return fmt::format("the sun's elevation is 0 to 90 degrees, not {}", sky.elevation);
  }
  if (!(std::abs(sky.azimuth) <= 360)) return fmt::format("the sun's azimuth is -360 to 360, not {}", sky.azimuth);
  if (!(sky.turbidity >= 2 && sky.turbidity <= 10)) {
    return fmt::format("turbidity is 2 to 10, not {}", sky.turbidity);
  }
  return std::nullopt;
}

EnvironmentMap make_sky(const Sky& sky) {
  const SkyColours colours(sky);
  std::vector<glm::dvec3> upper;
  upper.reserve(std::size_t{kWidth} * kHeight / 2);
  for (uint32_t row = 0; row < kHeight / 2; ++row) {
    for (uint32_t column = 0; column < kWidth; ++column) {
      upper.push_back(colours.at(direction_at({(column + 0.5) / kWidth, (row + 0.5) / kHeight})));
    }
  }
  const double scale = kPi / irradiance(upper);
  EnvironmentMap map{kWidth, kHeight, {}};
  map.radiance.reserve(std::size_t{kWidth} * kHeight);
  for (const glm::dvec3& colour : upper) map.radiance.emplace_back(colour * scale);
  map.radiance.resize(std::size_t{kWidth} * kHeight, glm::vec3(kGroundReflectance));
  return map;
}

}  // namespace texbrdf::lighting
