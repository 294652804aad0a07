#include "render/tone_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace texbrdf::render {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A row of points in full light, one pixel each.
SphereGeometry row_of(std::size_t count) {
  SphereGeometry geometry;
  geometry.size = 64;
  geometry.alpha.assign(64 * 64, 255);
  for (uint32_t i = 0; i < count; ++i) geometry.pixels.push_back(i);
  geometry.cosines.assign(count, 1.0F);
  return geometry;
}

Picture grey_row(const std::vector<float>& values, const SphereView& view) {
  return tone_map(row_of(values.size()), view, {{values.data(), values.data(), values.data()}, 1});
}

class Gammas : public testing::TestWithParam<double> {};

TEST_P(Gammas, EveryValueIsRoundedAsThePowerIs) {
  const SphereView view{.size = 64, .gamma = GetParam(), .exposure = 0};
  std::vector<float> values;
  for (double value = 1e-9; value < 1.2; value *= 1.0061) values.push_back(static_cast<float>(value));
  ASSERT_LT(values.size(), 64U * 64);
  const Picture picture = grey_row(values, view);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double exact = 255 * std::min(1.0, std::pow(static_cast<double>(values[i]), 1 / GetParam()));
    EXPECT_NEAR(picture.image.pixels[i * 4], exact, 0.5 + 1e-4) << values[i];
  }
}

INSTANTIATE_TEST_SUITE_P(ToneMap, Gammas, testing::Values(0.1, 0.5, 1.0, 2.112, 2.2, 10.0));

TEST(ToneMap, AppliesCosineAndExposure) {
  SphereGeometry geometry = row_of(2);
  geometry.cosines[1] = 0.5F;
  const std::vector<float> values{0.1F, 0.1F};
  const Picture picture =
      tone_map(geometry, {.size = 64, .gamma = 1, .exposure = 2}, {{values.data(), values.data(), values.data()}, 1});
  EXPECT_EQ(picture.image.pixels[0], 102);
  EXPECT_EQ(picture.image.pixels[4], 51);
}

TEST(ToneMap, KeepsChannelsApartAndReadsWithAStride) {
  const std::vector<float> values{0.2F, 0.4F, 0.6F, 9, 1, 0, 0.8F, 9};
  const Picture picture = tone_map(row_of(2), {.size = 64, .gamma = 1, .exposure = 0},
                                   {{values.data(), values.data() + 1, values.data() + 2}, 4});
  const std::vector<uint8_t> first(picture.image.pixels.begin(), picture.image.pixels.begin() + 8);
  EXPECT_EQ(first, (std::vector<uint8_t>{51, 102, 153, 255, 255, 0, 204, 255}));
}

struct BadCase {
  std::array<float, 3> value;
  std::optional<BadPixel> expected;
};

TEST(ToneMap, BadValuesAreMarkedAndCounted) {
  const std::vector<BadCase> cases{
      {{kNaN, 0, 0}, BadPixel::NotANumber},
      {{0, 0, -kNaN}, BadPixel::NotANumber},
      {{kInfinity, -1, kNaN}, BadPixel::NotANumber},
      {{0, kInfinity, 0}, BadPixel::Infinite},
      {{-kInfinity, 0, 0}, BadPixel::Infinite},
      {{-1, kInfinity, 0}, BadPixel::Infinite},
      {{0, 0, -1}, BadPixel::Negative},
      {{-1e-40F, 0, 0}, BadPixel::Negative},
      {{0, -0.0F, 0}, std::nullopt},
      {{std::numeric_limits<float>::max(), 0, 0}, std::nullopt},
  };
  std::array<std::vector<float>, 3> channels;
  for (const BadCase& bad : cases) {
    for (std::size_t c = 0; c < 3; ++c) channels[c].push_back(bad.value[c]);
  }
  const Picture picture =
      tone_map(row_of(cases.size()), {.size = 64}, {{channels[0].data(), channels[1].data(), channels[2].data()}, 1});
  BadPixelCounts expected;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (!cases[i].expected) continue;
    ++expected[*cases[i].expected];
    const uint8_t* pixel = &picture.image.pixels[i * 4];
    EXPECT_EQ((std::array{pixel[0], pixel[1], pixel[2]}), bad_pixel_entry(*cases[i].expected).colour) << i;
    EXPECT_EQ(pixel[3], 255);
  }
  EXPECT_EQ(picture.bad_pixels, expected);
}

TEST(ToneMap, PixelsWithoutAPointAreBlackWithTheirAlpha) {
  SphereGeometry geometry = row_of(1);
  geometry.alpha[5] = 77;
  const float value = 1;
  const Picture picture = tone_map(geometry, {.size = 64}, {{&value, &value, &value}, 1});
  EXPECT_EQ(std::vector<uint8_t>(picture.image.at(5, 0), picture.image.at(5, 0) + 4),
            (std::vector<uint8_t>{0, 0, 0, 77}));
}

TEST(BadPixels, AreDescribedInWords) {
  BadPixelCounts counts;
  EXPECT_EQ(describe(counts), "");
  counts[BadPixel::NotANumber] = 12;
  EXPECT_EQ(describe(counts), "12 pixels are not a number (magenta)");
  counts[BadPixel::Negative] = 1;
  EXPECT_EQ(describe(counts), "12 pixels are not a number (magenta), 1 is negative (yellow)");
  EXPECT_EQ(counts.total(), 13U);
  counts = {};
  counts[BadPixel::Infinite] = 1;
  EXPECT_EQ(describe(counts), "1 pixel is infinite (cyan)");
}

}  // namespace
}  // namespace texbrdf::render
