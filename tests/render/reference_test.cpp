#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "render/png.h"
#include "support.h"
#include "support/read_png.h"

// Small pictures that a person has looked at. GOLDEN_UPDATE=1 writes them anew.

namespace texbrdf {
namespace {

constexpr int kTolerance = 3;  // of 255: other drivers and instruction sets round otherwise

std::string reference_path(const std::string& model) {
  return std::string(TEXBRDF_SOURCE_DIR) + "/tests/render/reference/" + model + ".png";
}

render::Picture picture_of(const std::string& model) {
  const auto prepared = preview::cpu_model(test::model_program(model));
  EXPECT_TRUE(prepared) << prepared.error();
  render::SphereCache cache;
  return preview::draw_on_cpu(*prepared, {.size = 64}, cache);
}

class Reference : public testing::TestWithParam<std::string> {};

TEST_P(Reference, LooksAsItDid) {
  const render::ImageRgba8 image = picture_of(GetParam()).image;
  if (std::getenv("GOLDEN_UPDATE") != nullptr) {
    const std::vector<uint8_t> file = encode_png(image, render::PngEffort::Small);
    std::ofstream(reference_path(GetParam()), std::ios::binary)
        .write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
  }
  const auto reference = test::read_png_file(reference_path(GetParam()));
  ASSERT_TRUE(reference);
  ASSERT_EQ(reference->pixels.size(), image.pixels.size());
  int largest = 0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    largest = std::max(largest, std::abs(int{image.pixels[i]} - int{reference->pixels[i]}));
  }
  EXPECT_LE(largest, kTolerance);
}

INSTANTIATE_TEST_SUITE_P(Models, Reference, testing::ValuesIn(test::model_names()), test::test_name);

}  // namespace
}  // namespace texbrdf
