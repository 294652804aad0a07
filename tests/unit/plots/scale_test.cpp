#include "plots/scale.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace texbrdf::plots {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Scale scale_of(ScaleKind kind, const std::vector<double>& values, std::optional<double> maximum = std::nullopt) {
  return scale_for(kind, values, maximum);
}

std::string text_of(const Scale& scale, double value) {
  std::string text;
  for (const Run& run : tick_text(scale, value)) text += (run.script == Script::Super ? "^" : "") + run.text;
  return text;
}

TEST(Scale, LinearEndsAreMultiplesOfAStepThatPeopleWouldChoose) {
  const Scale scale = scale_of(ScaleKind::Linear, {0.013, 3.7});
  EXPECT_EQ(scale.ticks, (std::vector<double>{0, 1, 2, 3, 4}));
  EXPECT_EQ(scale.low, 0);
  EXPECT_EQ(scale.high, 4);
  EXPECT_EQ(*scale.fraction_of(1), 0.25);
  EXPECT_EQ(*scale.fraction_of(-1), -0.25);
}

TEST(Scale, NegativeValuesHaveAPlaceOnALinearAxis) {
  const Scale scale = scale_of(ScaleKind::Linear, {-0.3, 0.9});
  EXPECT_LE(scale.low, -0.3);
  EXPECT_GE(scale.high, 0.9);
  EXPECT_EQ(std::ranges::count(scale.ticks, 0), 1);
}

TEST(Scale, LogarithmicEndsAreDecades) {
  const Scale scale = scale_of(ScaleKind::Log, {0.02, 30, 0, -1});
  EXPECT_EQ(scale.low, -2);
  EXPECT_EQ(scale.high, 2);
  EXPECT_NEAR(*scale.fraction_of(1), 0.5, 1e-12);
  EXPECT_EQ(scale.fraction_of(0), std::nullopt);
  EXPECT_EQ(scale.fraction_of(-1), std::nullopt);
}

TEST(Scale, ManyDecadesAreCutOff) {
  const Scale scale = scale_of(ScaleKind::Log, {1e-200, 1});
  EXPECT_EQ(scale.low, -8);
  EXPECT_EQ(scale.high, 0);
}

TEST(Scale, WhatIsNoNumberCountsForNothing) {
  for (const ScaleKind kind : {ScaleKind::Linear, ScaleKind::Log}) {
    const Scale scale = scale_of(kind, {NAN, kInfinity, -kInfinity, 2});
    EXPECT_TRUE(std::isfinite(scale.low) && std::isfinite(scale.high));
    EXPECT_LT(scale.low, scale.high);
    EXPECT_EQ(scale.fraction_of(NAN), std::nullopt);
    EXPECT_EQ(scale.fraction_of(kInfinity), std::nullopt);
  }
}

TEST(Scale, AnyValuesGiveEndsAndSomeTicks) {
  for (const ScaleKind kind : {ScaleKind::Linear, ScaleKind::Log}) {
    for (const double value : {0.0, 5e-324, 1e-310, 1e-20, 1.0, 1e20, 1.7e308, -1.7e308, -1e-320}) {
      for (const double other : {0.0, 1.0, 1.7e308}) {
        const Scale scale = scale_of(kind, {value, other});
        EXPECT_LT(scale.low, scale.high) << value << " " << other;
        EXPECT_GE(scale.ticks.size(), 2U) << value << " " << other;
        EXPECT_LE(scale.ticks.size(), 20U) << value << " " << other;
      }
    }
  }
}

TEST(Scale, AMaximumTakesThePlaceOfTheLargest) {
  EXPECT_EQ(scale_of(ScaleKind::Linear, {100}, 2).high, 2);
  EXPECT_EQ(scale_of(ScaleKind::Log, {0.1, 100}, 1).high, 0);
}

TEST(Scale, TicksHaveTheDigitsThatTheyNeed) {
  const Scale linear = scale_of(ScaleKind::Linear, {1});
  EXPECT_EQ(text_of(linear, 0), "0");
  EXPECT_EQ(text_of(linear, 0.30000000000000004), "0.3");
  EXPECT_EQ(text_of(linear, -2.5), "−2.5");
  EXPECT_EQ(text_of(linear, 50000), "50000");
  EXPECT_EQ(text_of(linear, 2e6), "2·10^6");
  EXPECT_EQ(text_of(linear, 5e-5), "5·10^−5");
  const Scale log = scale_of(ScaleKind::Log, {1e-6, 1});
  EXPECT_EQ(text_of(log, 0.1), "0.1");
  EXPECT_EQ(text_of(log, 1e-6), "10^−6");
}

}  // namespace
}  // namespace texbrdf::plots
