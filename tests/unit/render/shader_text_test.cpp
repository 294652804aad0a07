#include "render/shader_text.h"

#include <gtest/gtest.h>

#include "render/glsl_check.h"

namespace texbrdf::render {
namespace {

constexpr const char* kLambert = "vec3 brdf(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return vec3(0.3); }\n";

TEST(ShaderText, IsGlslForEverySourceOfGeometry) {
  const GlslChecker checker;
  for (const GeometrySource geometry : {GeometrySource::Sphere, GeometrySource::Table}) {
    EXPECT_EQ(checker.find_fault(shader_text(kLambert, geometry).fragment), std::nullopt);
  }
}

TEST(ShaderText, AvoidsTheNamesOfTheSource) {
  const std::string source = std::string("uniform float host0_normal;\nuniform float host1_light;\n") + kLambert;
  const ShaderText text = shader_text(source, GeometrySource::Sphere);
  EXPECT_EQ(text.prefix, "host2_");
  const GlslChecker checker;
  EXPECT_EQ(checker.find_fault(text.fragment), std::nullopt);
}

TEST(GlslChecker, GivesTheFirstComplaintInOneLine) {
  const GlslChecker checker;
  const auto fault = checker.find_fault(
      shader_text("vec3 brdf(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {\n  return wrong;\n}\n", GeometrySource::Sphere)
          .fragment);
  ASSERT_TRUE(fault);
  EXPECT_EQ(*fault, "0:2: 'wrong' : undeclared identifier");
}

TEST(GlslChecker, FindsAFunctionWithoutABody) {
  const GlslChecker checker;
  EXPECT_TRUE(checker.find_fault(
      shader_text("vec3 brdf(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y);\n", GeometrySource::Table).fragment));
}

}  // namespace
}  // namespace texbrdf::render
