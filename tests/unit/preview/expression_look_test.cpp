#include "preview/expression_look.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/document.h"
#include "support/read_png.h"

namespace texbrdf::preview {
namespace {

std::string equation(const std::string& text) {
  return "\\begin{equation}\n" + text + "\n\\end{equation}\n";
}

ExpressionLook look_at(const std::string& equations) {
  Document document(equations);
  const auto program = document.snapshot().program("f");
  EXPECT_TRUE(program) << program.error();
  const auto look = ExpressionSampler().look(*program);
  EXPECT_TRUE(look);
  return look.value_or(ExpressionLook{});
}

std::array<int, 4> pixel(const ExpressionLook& look, uint32_t x, uint32_t y) {
  const render::ImageRgba8 image = test::PngReader(look.png).read().value_or(render::ImageRgba8{});
  EXPECT_EQ(image.width, kLookSize);
  const uint8_t* at = image.at(x, y);
  return {at[0], at[1], at[2], at[3]};
}

TEST(ExpressionLook, WhatIsTheSameInAllDirectionsHasAValueAndNoPicture) {
  const ExpressionLook look = look_at(equation("f = 2 * m + 0.25") + equation("m = 0.5"));
  EXPECT_EQ(look.least, std::vector<double>{1.25});
  EXPECT_EQ(look.most, look.least);
  EXPECT_TRUE(look.png.empty());
  EXPECT_EQ(look_at(equation("f = \\vec{1, 2, 3} * 2")).least, (std::vector<double>{2, 4, 6}));
}

TEST(ExpressionLook, ExtremesAreThoseOfTheHemisphere) {
  const ExpressionLook look = look_at(equation("f = \\vec{n} \\cdot \\omega_i"));
  EXPECT_NEAR(look.least.at(0), 0, 0.01);
  EXPECT_NEAR(look.most.at(0), 1, 0.01);
  EXPECT_FALSE(look.has_nan);
}

TEST(ExpressionLook, MirroredAndReturnedLightIsAmongTheSamples) {
  EXPECT_NEAR(look_at(equation("f = \\vec{n} \\cdot \\vec{h}")).most.at(0), 1, 1e-6);
  EXPECT_NEAR(look_at(equation("f = \\omega_i \\cdot \\omega_o")).most.at(0), 1, 1e-6);
}

TEST(ExpressionLook, EachComponentHasItsExtremes) {
  const ExpressionLook look = look_at(equation("f = \\vec{1, 2, 0} * (\\vec{n} \\cdot \\omega_i)"));
  ASSERT_EQ(look.most.size(), 3U);
  EXPECT_NEAR(look.most[1], 2 * look.most[0], 1e-6);
  EXPECT_EQ(look.most[2], 0);
}

TEST(ExpressionLook, SamplesThatAreNoNumbersAreLeftOutAndTold) {
  const ExpressionLook some = look_at(equation("f = \\sqrt{\\vec{n} \\cdot \\omega_i - 0.5}"));
  EXPECT_TRUE(some.has_nan);
  EXPECT_NEAR(some.most.at(0), std::sqrt(0.5), 0.01);
  const ExpressionLook all = look_at(equation("f = \\sqrt{-1 - \\vec{n} \\cdot \\omega_i}"));
  EXPECT_TRUE(all.has_nan);
  EXPECT_TRUE(all.least.empty());
  EXPECT_TRUE(all.most.empty());
}

TEST(ExpressionLook, ARealIsGreyAndAColourHasItsChannels) {
  const auto grey = pixel(look_at(equation("f = \\vec{n} \\cdot \\vec{h}")), 24, 24);
  EXPECT_EQ(grey[0], grey[1]);
  EXPECT_EQ(grey[1], grey[2]);
  EXPECT_GT(grey[0], 100);
  const auto red = pixel(look_at(equation("f = \\vec{1, 0, 0} * (\\vec{n} \\cdot \\vec{h})")), 24, 24);
  EXPECT_EQ(red[0], grey[0]);
  EXPECT_EQ(red[1], 0);
  EXPECT_EQ(pixel(look_at(equation("f = \\theta_h")), 0, 0)[3], 0);
}

TEST(ExpressionLook, ADirectionIsDrawnAsANormalMapIs) {
  const ExpressionLook normal = look_at(equation("f = \\vec{n}"));
  const auto left = pixel(normal, 8, 30);
  EXPECT_LT(left[0], 60);
  EXPECT_NEAR(left[1], 128, 10);
  const auto middle = pixel(normal, 32, 32);
  EXPECT_NEAR(middle[0], 128, 6);
  EXPECT_NEAR(middle[2], 255, 2);
}

TEST(ExpressionLook, BadValuesAreMarked) {
  EXPECT_EQ(pixel(look_at(equation("f = -\\theta_h")), 24, 24), (std::array{255, 255, 0, 255}));
  EXPECT_EQ(pixel(look_at(equation("f = \\sqrt{-1 - \\theta_h}")), 24, 24), (std::array{255, 0, 255, 255}));
}

}  // namespace
}  // namespace texbrdf::preview
