#include "lsp/json_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

namespace texbrdf::lsp {
namespace {

std::string written(const auto& value) {
  JsonWriter out;
  out.value(value);
  return out.take();
}

TEST(JsonWriter, CommasStandBetweenValues) {
  JsonWriter out;
  out.begin_object();
  out.member("a", 1);
  out.key("b");
  out.begin_array();
  out.value("x");
  out.begin_object();
  out.end_object();
  out.begin_array();
  out.end_array();
  out.null();
  out.value(true);
  out.end_array();
  out.member("c", false);
  out.key("d");
  out.raw("{\"e\":2}");
  out.end_object();
  EXPECT_EQ(out.text(), R"({"a":1,"b":["x",{},[],null,true],"c":false,"d":{"e":2}})");
}

TEST(JsonWriter, NumbersReadBackExactly) {
  EXPECT_EQ(written(std::numeric_limits<int64_t>::min()), "-9223372036854775808");
  EXPECT_EQ(written(std::numeric_limits<uint64_t>::max()), "18446744073709551615");
  EXPECT_EQ(written(0.1), "0.1");
  EXPECT_EQ(written(1e300), "1e+300");
  EXPECT_EQ(written(std::nan("")), "null");
  EXPECT_EQ(written(INFINITY), "null");
  for (const double number : {0.1, 1.0 / 3, 5e-324, 1.7976931348623157e308, -0.0}) {
    EXPECT_EQ(nlohmann::json::parse(written(number)).get<double>(), number);
  }
}

TEST(JsonWriter, StringsAreEscaped) {
  EXPECT_EQ(written("a\"b\\c\n\r\t\x01\x7f"), "\"a\\\"b\\\\c\\n\\r\\t\\u0001\x7f\"");
  EXPECT_EQ(written(std::string("nul\0!", 5)), "\"nul\\u0000!\"");
  EXPECT_EQ(written("ℝ³ 𝔹 \\rho"), "\"ℝ³ 𝔹 \\\\rho\"");
}

TEST(JsonWriter, BytesThatAreNoUtf8BecomeReplacementCharacters) {
  EXPECT_EQ(written("a\xff"
                    "b"),
            "\"a\uFFFDb\"");
  EXPECT_EQ(written("\xe2\x84"), "\"\uFFFD\uFFFD\"");
  EXPECT_EQ(written("\xed\xa0\x80"), "\"\uFFFD\uFFFD\uFFFD\"");
  for (int first = 0; first < 256; ++first) {
    for (int second = 0; second < 256; ++second) {
      const std::string bytes = {static_cast<char>(first), static_cast<char>(second)};
      ASSERT_TRUE(nlohmann::json::accept(written(bytes))) << first << ' ' << second;
    }
  }
}

}  // namespace
}  // namespace texbrdf::lsp
