#include "scene/user_code.h"

#include <gtest/gtest.h>

#include "scene/glsl_lexer.h"

namespace texbrdf::scene {
namespace {

constexpr std::string_view kShade = "float3 shade(FragmentProperties p) { return float3(1.0); }";

std::string fault_of(const std::string& code, std::vector<Property> properties = {}) {
  const auto fault = find_code_fault(Shader{"s", ShaderKind::Shade, std::move(properties), code, {}});
  return fault ? std::to_string(fault->line) + ": " + fault->message : "";
}

std::string with_shade(const std::string& code) {
  return code + "\n" + std::string(kShade) + "\n";
}

struct Case {
  std::string code;
  std::string fault;
};

TEST(UserCode, WhatWouldReachBeyondItIsRefused) {
  const std::vector<Case> cases = {
      {"", ""},
      {"#define A(x) { x }\n#ifdef A\n#else\n(\n#endif", ""},
      {"struct S { float3 a, b[2]; };\nconst S s = S(float3(0), float3[2](float3(0), float3(1)));", ""},
      {"float f(in float a, out float b, inout float c) { b = a; return c; }", ""},
      {"float x = .5e-3f + 0x1Fu; // (", ""},
      {"/* ( */ float scene_of_mine() { return 1.0; }", ""},
      {"void main() { }", ""},
      {"float x\n  = (1.0;", "1: this `(` is not closed"},
      {"float f() {\n", "0: this `{` is not closed"},
      {"float f() { return (1.0; }", "0: this `(` is not closed before a `}`"},
      {"}", "0: this `}` closes nothing"},
      {"\n/* never", "1: this comment is not closed"},
      {"#version 450", "0: `#version` is not allowed here: there are #define, #undef and conditionals"},
      {"\n  # extension all : enable",
       "1: `#extension` is not allowed here: there are #define, #undef and conditionals"},
      {"#line 7", "0: `#line` is not allowed here: there are #define, #undef and conditionals"},
      {"#if 1\n", "0: this conditional has no #endif"},
      {"#endif", "0: `#endif` without a conditional"},
      {"float f() { discard; }", "0: `discard` is not allowed in code of a scene"},
      {"float f() {\n gl_FragColor = vec4(1); }", "1: `gl_FragColor` is a name of the renderer"},
      {"float f() { return scene_distance(vec3(0)).x; }", "0: `scene_distance` is a name of the renderer"},
      {"uniform float x;", "0: `uniform` is not allowed in code of a scene"},
      {"out vec4 colour;", "0: `out` is not allowed in code of a scene"},
      {"struct FragmentProperties { float a; };", "0: `FragmentProperties` is declared already"},
      {"float a = 1.0 @ 2.0;", "0: here is a character that GLSL does not have"},
  };
  for (const Case& each : cases) EXPECT_EQ(fault_of(with_shade(each.code)), each.fault) << each.code;
}

TEST(UserCode, EndsWithWhatItBegins) {
  EXPECT_EQ(fault_of(with_shade("") + "float x"), "2: the code ends within a declaration: a `;` is missing");
  EXPECT_EQ(fault_of(with_shade("") + "struct S { float x; }"),
            "2: the code ends within a declaration: a `;` is missing");
}

TEST(UserCode, HasWhatItIsAskedFor) {
  EXPECT_EQ(fault_of("float x;"), "0: the code has no function `float3 shade(FragmentProperties properties)`");
  EXPECT_EQ(fault_of("float shade(FragmentProperties p) { return 1.0; }"),
            "0: `shade` is not declared as `float3 shade(FragmentProperties properties)`");
  EXPECT_EQ(fault_of("vec3 shade(FragmentProperties p) { return vec3(1); }"), "");
  const Property blend{"_Blend", PropertyType::Float, {}, {}};
  EXPECT_EQ(fault_of(with_shade(""), {blend}), "0: the code has no global `float _Blend;` for the property");
  EXPECT_EQ(fault_of(with_shade("\nfloat3 _Blend;"), {blend}),
            "1: the property `_Blend` is a float, its global a float3");
  EXPECT_EQ(fault_of(with_shade("float _Other, _Blend;"), {blend}), "");
  const auto fault =
      find_code_fault(UserPrimitive{40, "ball", "float bal(vec3 p, Primitive3D q) { return 1.0; }", {}, {}, 1});
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->message, "the code has no function `float ball(vec3 p, Primitive3D primitive)`");
}

TEST(UserCode, OnlyItsOwnNamesGetThePrefix) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"float a = b.a; // a", "float u_a = b.a; // a"},
      {"float f(float x) { return f(x) + g(x); }", "float u_f(float x) { return u_f(x) + g(x); }"},
      {"struct S { float a; float b; }; float a; float g(S s) { return s.a + a; }",
       "struct u_S { float a; float b; }; float u_a; float u_g(u_S s) { return s.a + u_a; }"},
      {"#define SQUARE(x) ((x) * (x))\nfloat f() { return SQUARE(2.0); }",
       "#define u_SQUARE(x) ((x) * (x))\nfloat u_f() { return u_SQUARE(2.0); }"},
      {"float3 c = lerp(x, y, saturate(z));", "vec3 u_c = mix(x, y, scene_saturate(z));"},
      {"float lerp(float a) { return lerp(a); }", "float u_lerp(float a) { return u_lerp(a); }"},
      {"uniform float x, y = 1.0;", " float u_x, u_y = 1.0;"},
      {"const float table[2] = float[2](1.0, 2.0);", "const float u_table[2] = float[2](1.0, 2.0);"},
  };
  for (const auto& [code, expected] : cases) EXPECT_EQ(with_prefix(code, "u_"), expected);
}

TEST(UserCode, TokensHaveAllBytesInOrder) {
  const std::string code = "#if 1 // a\n a+++b /* \n */ 1.e+5 0xe+1 .5 'x \\\n#endif \xC3\xA9 /*";
  std::string joined;
  for (const GlslToken& token : lex_glsl(code)) joined += token.text;
  EXPECT_EQ(joined, code);
}

}  // namespace
}  // namespace texbrdf::scene
