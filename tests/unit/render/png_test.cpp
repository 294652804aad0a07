#include "render/png.h"

#include <gtest/gtest.h>

#include <random>

#include "support/read_png.h"

namespace texbrdf::render {
namespace {

ImageRgba8 noise(uint32_t width, uint32_t height, bool opaque) {
  std::mt19937 random(width * 131 + height);
  ImageRgba8 image{width, height, std::vector<uint8_t>(std::size_t{width} * height * 4)};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    image.pixels[i] = opaque && i % 4 == 3 ? uint8_t{255} : static_cast<uint8_t>(random());
  }
  return image;
}

/// Smooth in every direction, so that each filter is the best one of some row.
ImageRgba8 slopes(uint32_t size) {
  ImageRgba8 image{size, size, {}};
  for (uint32_t y = 0; y < size; ++y) {
    for (uint32_t x = 0; x < size; ++x) {
      const std::array<uint32_t, 4> kinds{x * 3, y * 5, x * y / 7, x + y};
      const uint32_t value = kinds[(y / 8) % 4];
      for (const uint32_t c : {value, value * 2, value + x, value + 40}) {
        image.pixels.push_back(static_cast<uint8_t>(c));
      }
    }
  }
  return image;
}

class RoundTrip : public testing::TestWithParam<PngEffort> {};

TEST_P(RoundTrip, KeepsEveryPixel) {
  for (const ImageRgba8& image : {noise(1, 1, false), noise(1, 1, true), noise(3, 17, true), noise(64, 2, false),
                                  noise(257, 33, false), slopes(65)}) {
    const auto decoded = test::read_png(encode_png(image, GetParam()));
    ASSERT_TRUE(decoded) << image.width << " x " << image.height;
    EXPECT_EQ(decoded->width, image.width);
    EXPECT_EQ(decoded->height, image.height);
    EXPECT_EQ(decoded->pixels, image.pixels);
  }
}

INSTANTIATE_TEST_SUITE_P(Png, RoundTrip, testing::Values(PngEffort::Fast, PngEffort::Small));

TEST(Png, SmallIsSmallerThanFastOnASmoothPicture) {
  const ImageRgba8 image = slopes(128);
  EXPECT_LT(encode_png(image, PngEffort::Small).size(), encode_png(image, PngEffort::Fast).size());
}

TEST(Png, OpaqueImagesHaveNoAlphaChannel) {
  constexpr std::size_t kColourTypeAt = 25;
  EXPECT_EQ(encode_png(noise(4, 4, true), PngEffort::Fast)[kColourTypeAt], 2);
  EXPECT_EQ(encode_png(noise(4, 4, false), PngEffort::Fast)[kColourTypeAt], 6);
}

TEST(Png, TheReaderRefusesADamagedFile) {
  std::vector<uint8_t> file = encode_png(noise(8, 8, true), PngEffort::Fast);
  file[60] ^= 1;
  EXPECT_FALSE(test::read_png(file));
}

}  // namespace
}  // namespace texbrdf::render
