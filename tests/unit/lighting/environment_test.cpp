#include "lighting/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "lighting/light_sample.h"
#include "lighting/sky.h"
#include "support/random.h"

namespace texbrdf::lighting {
namespace {

constexpr double kPi = std::numbers::pi;

/// Texels from black to a thousand, some rows black as a whole.
EnvironmentMap uneven_map() {
  test::Random random(7);
  EnvironmentMap map{32, 16, {}};
  for (uint32_t row = 0; row < map.height; ++row) {
    for (uint32_t column = 0; column < map.width; ++column) {
      const double strength = row == 3 || random.below(3) == 0 ? 0 : std::pow(10, random.real(-3, 3));
      map.radiance.emplace_back(strength, strength * random.real(0, 1), strength * random.real(0, 1));
    }
  }
  return map;
}

glm::dvec3 centre_of(const EnvironmentMap& map, uint32_t row, uint32_t column) {
  return direction_at({(column + 0.5) / map.width, (row + 0.5) / map.height});
}

double solid_angle(const EnvironmentMap& map, uint32_t row) {
  return 2 * kPi / map.width * (std::cos(kPi * row / map.height) - std::cos(kPi * (row + 1) / map.height));
}

/// ∫ L · max(0, N·ω) dω, by many points in each texel.
glm::dvec3 irradiance(const EnvironmentMap& map, const glm::dvec3& normal) {
  const uint32_t points = map.width > 100 ? 2 : 24;  // along a side of a texel
  glm::dvec3 sum(0);
  for (uint32_t row = 0; row < map.height; ++row) {
    for (uint32_t column = 0; column < map.width; ++column) {
      double cosines = 0;
      for (uint32_t i = 0; i < points * points; ++i) {
        const double x = (column + (i % points + 0.5) / points) / map.width;
        const double high = std::cos(kPi * row / map.height);
        const double low = std::cos(kPi * (row + 1) / map.height);
        const double y = std::acos(high + (low - high) * (static_cast<double>(i / points) + 0.5) / points) / kPi;
        cosines += std::max(0.0, glm::dot(direction_at({x, y}), normal));
      }
      sum += glm::dvec3(map.radiance[row * map.width + column]) * (cosines / (points * points) * solid_angle(map, row));
    }
  }
  return sum;
}

TEST(Environment, RowsGoFromTheZenithAndTheMiddleIsInFront) {
  EXPECT_NEAR(glm::length(direction_at({0.5, 0}) - glm::dvec3(0, 1, 0)), 0, 1e-12);
  EXPECT_NEAR(glm::length(direction_at({0.5, 0.5}) - glm::dvec3(0, 0, -1)), 0, 1e-12);
  EXPECT_NEAR(glm::length(direction_at({0.75, 0.5}) - glm::dvec3(1, 0, 0)), 0, 1e-12);
  EXPECT_NEAR(glm::length(direction_at({0, 0.5}) - glm::dvec3(0, 0, 1)), 0, 1e-12);
}

TEST(Environment, FindsEachTexelInItsDirection) {
  const EnvironmentMap map = uneven_map();
  const Environment environment(map);
  for (uint32_t row = 0; row < map.height; ++row) {
    for (uint32_t column = 0; column < map.width; ++column) {
      EXPECT_EQ(environment.radiance(centre_of(map, row, column)), map.radiance[row * map.width + column]);
    }
  }
}

TEST(Environment, TheDensityOfSamplesIntegratesToOne) {
  for (const EnvironmentMap& map : {uneven_map(), make_sky({}), Environment::furnace().map()}) {
    const Environment environment(map);
    double sum = 0;
    for (uint32_t row = 0; row < map.height; ++row) {
      for (uint32_t column = 0; column < map.width; ++column) {
        sum += environment.density(centre_of(map, row, column)) * solid_angle(map, row);
      }
    }
    EXPECT_NEAR(sum, 1, 1e-9);
  }
}

/// Pearson's χ² over the texels that are expected at least ten times, the others as one.
TEST(Environment, SamplesAreSpreadAsTheDensitySays) {
  const EnvironmentMap map = uneven_map();
  const Environment environment(map);
  constexpr uint32_t kSide = 1000;
  std::vector<double> counts(map.radiance.size());
  test::Random random(3);
  for (uint32_t i = 0; i < kSide * kSide; ++i) {
    const glm::dvec3 direction = environment.sample({random.real(0, 1), random.real(0, 1)});
    EXPECT_NEAR(glm::length(direction), 1, 1e-9);
    const double row = std::floor(std::acos(direction.y) / kPi * map.height);
    const double column = std::floor((0.5 + std::atan2(direction.x, -direction.z) / (2 * kPi)) * map.width);
    ++counts[static_cast<std::size_t>(std::min(row, map.height - 1.0) * map.width + std::min(column, map.width - 1.0))];
  }
  double statistic = 0;
  double degrees = 0;
  double rare = 0;
  double rare_expected = 0;
  for (uint32_t i = 0; i < counts.size(); ++i) {
    const double density = environment.density(centre_of(map, i / map.width, i % map.width));
    const double expected = density * solid_angle(map, i / map.width) * kSide * kSide;
    if (expected == 0) {
      EXPECT_EQ(counts[i], 0) << "a black texel";
    }
    if (expected < 10) {
      rare += counts[i];
      rare_expected += expected;
      continue;
    }
    statistic += (counts[i] - expected) * (counts[i] - expected) / expected;
    ++degrees;
  }
  EXPECT_GT(degrees, 100);
  EXPECT_NEAR(rare, rare_expected, 5 * std::sqrt(rare_expected) + 1);
  // χ² has the mean `degrees` and the variance 2 · `degrees`.
  EXPECT_NEAR(statistic, degrees, 5 * std::sqrt(2 * degrees));
}

TEST(Environment, TheEndsOfTheRandomNumbersGiveDirections) {
  EnvironmentMap map{4, 2, std::vector<glm::vec3>(8, glm::vec3(0))};
  map.radiance[1] = glm::vec3(1);
  const Environment environment(map);
  const double last = std::nextafter(1.0, 0.0);
  for (const glm::dvec2& random : {glm::dvec2(0, 0), {last, 0}, {0, last}, {last, last}}) {
    EXPECT_NEAR(glm::length(environment.sample(random)), 1, 1e-9);
  }
  // On the edge between texels itself, rounding decides.
  for (const glm::dvec2& random : {glm::dvec2(1e-6, 1e-6), {1 - 1e-6, 1e-6}, {1e-6, 1 - 1e-6}, {1 - 1e-6, 1 - 1e-6}}) {
    EXPECT_EQ(environment.radiance(environment.sample(random)), glm::vec3(1));
  }
}

struct Mean {
  glm::dvec3 value{0};
  double error = 0;  ///< standard error of the luminance
};

/// Of the weights, over many pixels: each is a sequence of its own.
template <typename Weight>
Mean mean_of(uint32_t pixels, uint32_t samples, const Weight& weight) {
  glm::dvec3 sum(0);
  double squares = 0;
  for (uint32_t pixel = 0; pixel < pixels; ++pixel) {
    glm::dvec3 of_pixel(0);
    for (uint32_t i = 0; i < samples; ++i) of_pixel += weight(SampleSequence(pixel), i);
    of_pixel /= samples;
    sum += of_pixel;
    squares += luminance(of_pixel) * luminance(of_pixel);
  }
  const glm::dvec3 mean = sum / static_cast<double>(pixels);
  const double variance = squares / pixels - luminance(mean) * luminance(mean);
  return {mean, std::sqrt(std::max(variance, 0.0) / pixels)};
}

const std::vector<glm::dvec3> kNormals{{0, 1, 0}, {0, -1, 0}, {0, 0, 1}, glm::normalize(glm::dvec3(1, -0.3, -0.5))};

TEST(LightSample, TheMeanOfTheWeightsIsTheIrradiance) {
  for (const EnvironmentMap& map : {uneven_map(), make_sky({20, 100, 4})}) {
    const Environment environment(map);
    for (const glm::dvec3& normal : kNormals) {
      const double expected = luminance(irradiance(map, normal));
      for (const uint32_t samples : {1U, 2U, 7U, 64U}) {
        const Mean mean = mean_of(2000, samples, [&](const SampleSequence& sequence, uint32_t index) {
          return sample_light(environment, normal, sequence, index).weight;
        });
        // Five standard errors, and what the quadrature may be off by.
        EXPECT_NEAR(luminance(mean.value), expected, 5 * mean.error + 2e-3 * expected) << samples;
      }
    }
  }
}

/// A narrow lobe in the place of a BRDF: the same mean as with samples by cosine alone.
TEST(LightSample, TheBalanceHeuristicAgreesWithSamplesByCosine) {
  const EnvironmentMap map = uneven_map();
  const Environment environment(map);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.2, 0.7, 0.6));
  const glm::dvec3 lobe = glm::normalize(glm::dvec3(-0.3, 0.6, 0.9));
  const auto f = [&](const glm::dvec3& direction) { return std::pow(std::max(0.0, glm::dot(direction, lobe)), 20); };
  const Mean both = mean_of(4000, 16, [&](const SampleSequence& sequence, uint32_t index) {
    const LightSample sample = sample_light(environment, normal, sequence, index);
    return sample.weight * f(sample.direction);
  });
  // The samples of a uniform light are by cosine: only their directions are of use here.
  const Environment furnace = Environment::furnace();
  const Mean by_cosine = mean_of(20000, 64, [&](const SampleSequence& sequence, uint32_t index) {
    const LightSample sample = sample_light(furnace, normal, sequence, index);
    return sample.weight * glm::dvec3(environment.radiance(sample.direction)) * f(sample.direction);
  });
  EXPECT_NEAR(luminance(both.value), luminance(by_cosine.value), 5 * std::hypot(both.error, by_cosine.error));
}

TEST(LightSample, InAFurnaceEachWeightIsPi) {
  const Environment furnace = Environment::furnace();
  for (const glm::dvec3& normal : kNormals) {
    for (uint32_t i = 0; i < 1000; ++i) {
      const LightSample sample = sample_light(furnace, normal, SampleSequence(5), i);
      EXPECT_NEAR(glm::length(sample.direction), 1, 1e-9);
      EXPECT_NEAR(sample.weight.x, kPi, 1e-9);
    }
  }
}

TEST(LightSample, IsTheSameForTheSamePixelAndIndex) {
  const Environment environment(uneven_map());
  for (uint32_t i = 0; i < 100; ++i) {
    const LightSample a = sample_light(environment, kNormals[3], SampleSequence(9), i);
    const LightSample b = sample_light(environment, kNormals[3], SampleSequence(9), i);
    EXPECT_EQ(a.direction, b.direction);
    EXPECT_EQ(a.weight, b.weight);
  }
}

}  // namespace
}  // namespace texbrdf::lighting
