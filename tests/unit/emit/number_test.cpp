#include "emit/number.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cstdlib>

namespace texbrdf::emit {
namespace {

TEST(Number, IsTheShortestThatReadsBack) {
  EXPECT_EQ(plain_number(0.3), "0.3");
  EXPECT_EQ(plain_number(256), "256");
  EXPECT_EQ(plain_number(-0.5), "-0.5");
  EXPECT_EQ(plain_number(1.192092896e-07), "1.1920929e-7");
  EXPECT_EQ(plain_number(3.141592653589793), "3.1415927");
  EXPECT_EQ(plain_number(1e10), "1e10");
  EXPECT_EQ(plain_number(0.0001), "0.0001");
  EXPECT_EQ(plain_number(0), "0");
}

TEST(Number, HasADotAsALiteral) {
  EXPECT_EQ(float_literal(256), "256.0");
  EXPECT_EQ(float_literal(0.25), "0.25");
  EXPECT_EQ(float_literal(1e10), "1.0e10");
  EXPECT_EQ(float_literal(1.5e-10), "1.5e-10");
}

TEST(Number, ReadsBackToTheSameSingle) {
  float number = FLT_TRUE_MIN;
  for (int i = 0; i < 3000 && number < FLT_MAX; ++i, number *= 1.07f) {
    EXPECT_EQ(std::strtof(plain_number(number).c_str(), nullptr), number);
    EXPECT_EQ(std::strtof(float_literal(number).c_str(), nullptr), number);
  }
}

}  // namespace
}  // namespace texbrdf::emit
