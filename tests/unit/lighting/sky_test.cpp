#include "lighting/sky.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/trigonometric.hpp>
#include <limits>
#include <numbers>

namespace texbrdf::lighting {
namespace {

glm::dvec3 towards(double elevation, double azimuth) {
  const double height = glm::radians(elevation);
  const double around = glm::radians(azimuth);
  return {std::cos(height) * std::sin(around), std::sin(height), std::cos(height) * std::cos(around)};
}

struct Colour {
  double elevation;
  double azimuth;
  glm::dvec3 rgb;  ///< over the luminance of the zenith
};

struct Reference {
  Sky sky;
  std::vector<Colour> colours;
};

/// By a program of its own, with the coefficients to five digits that other implementations have.
const std::vector<Reference> kReferences{
    {{45, -30, 3},
     {{80, 0, {0.8089, 1.2074, 2.2697}},
      {45, -30, {3.3727, 3.9399, 5.2502}},
      {30, 150, {0.4411, 0.8312, 1.5093}},
      {5, 40, {1.3294, 1.2770, 1.4686}},
      {60, -120, {0.5877, 0.9728, 1.8783}}}},
    {{10, 90, 2.5},
     {{80, 0, {0.7021, 1.0384, 1.6549}},
      {45, -30, {0.8043, 1.2160, 1.8473}},
      {30, 150, {1.7576, 2.1401, 2.8132}},
      {5, 40, {4.9154, 3.9965, 2.7287}},
      {60, -120, {0.6635, 1.0379, 1.6400}}}},
    {{80, 0, 6},
     {{80, 0, {1.0983, 1.3260, 1.7162}},
      {45, -30, {0.4069, 0.5824, 0.8506}},
      {30, 150, {0.2333, 0.3697, 0.5006}},
      {5, 40, {0.3356, 0.3218, 0.3146}},
      {60, -120, {0.3772, 0.5797, 0.9071}}}},
};

TEST(Sky, HasTheColoursOfThePaper) {
  for (const Reference& reference : kReferences) {
    const Environment sky(make_sky(reference.sky));
    const double zenith = luminance(glm::dvec3(sky.radiance({0, 1, 0})));
    for (const Colour& colour : reference.colours) {
      const glm::dvec3 seen = glm::dvec3(sky.radiance(towards(colour.elevation, colour.azimuth))) / zenith;
      for (int c = 0; c < 3; ++c) {
        // A texel has the colour of its middle, up to half a degree away.
        EXPECT_NEAR(seen[c], colour.rgb[c], 0.04 * colour.rgb[c]) << reference.sky.elevation << ' ' << colour.elevation;
      }
    }
  }
}

TEST(Sky, GivesLevelGroundTheIrradiancePi) {
  const EnvironmentMap map = make_sky({30, 200, 5});
  double sum = 0;
  for (uint32_t row = 0; row < map.height / 2; ++row) {
    const double angle = std::numbers::pi * (row + 0.5) / map.height;
    const double weight =
        std::sin(angle) * std::cos(angle) * (std::numbers::pi / map.height) * (2 * std::numbers::pi / map.width);
    for (uint32_t column = 0; column < map.width; ++column) {
      sum += luminance(glm::dvec3(map.radiance[row * map.width + column])) * weight;
    }
  }
  EXPECT_NEAR(sum, std::numbers::pi, 1e-3);
  EXPECT_EQ(map.radiance.back(), glm::vec3(0.2F));
}

TEST(Sky, IsFiniteAndNotNegativeInItsWholeRange) {
  for (const double elevation : {0.0, 1.0, 30.0, 89.0, 90.0}) {
    for (const double turbidity : {2.0, 2.2, 4.0, 7.0, 10.0}) {
      for (const glm::vec3& colour : make_sky({elevation, 0, turbidity}).radiance) {
        for (int c = 0; c < 3; ++c) ASSERT_TRUE(colour[c] >= 0 && std::isfinite(colour[c])) << elevation << turbidity;
        ASSERT_GT(luminance(glm::dvec3(colour)), 0) << elevation << ' ' << turbidity;
      }
    }
  }
}

TEST(Sky, IsBrighterTowardsTheSun) {
  for (const double azimuth : {-90.0, 0.0, 120.0}) {
    const Environment sky(make_sky({30, azimuth, 3}));
    const auto bright = [&](double around) { return luminance(glm::dvec3(sky.radiance(towards(30, around)))); };
    EXPECT_GT(bright(azimuth), 3 * bright(azimuth + 90));
  }
}

TEST(Sky, FaultsAreTold) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(find_fault(Sky{}));
  EXPECT_FALSE(find_fault({0, 360, 2}));
  for (const Sky& sky : {Sky{-1, 0, 3},
                         {91, 0, 3},
                         {kNan, 0, 3},
                         {45, kNan, 3},
                         {45, 361, 3},
                         {45, 0, 1.9},
                         {45, 0, 10.1},
                         {45, 0, kNan}}) {
    EXPECT_TRUE(find_fault(sky));
  }
}

}  // namespace
}  // namespace texbrdf::lighting
