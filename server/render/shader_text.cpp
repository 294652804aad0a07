#include "render/shader_text.h"

#include <fmt/format.h>

namespace texbrdf::render {

namespace {

constexpr std::string_view kSphereTemplate = R"(#version 330 core
uniform sampler2D {0}normal;
uniform vec3 {0}light;
uniform vec3 {0}view;
out vec4 {0}value;
#line 1
{1}
void main() {{
  vec3 {0}n = texelFetch({0}normal, ivec2(gl_FragCoord.xy), 0).xyz;
  vec3 {0}x = normalize(vec3({0}n.z, 0.0, -{0}n.x));
  {0}value = vec4(brdf({0}light, {0}view, {0}n, {0}x, cross({0}n, {0}x)), 1.0);
}}
)";

constexpr std::string_view kTableTemplate = R"(#version 330 core
uniform sampler2D {0}normal;
uniform sampler2D {0}light;
uniform sampler2D {0}view;
uniform sampler2D {0}tangent;
uniform sampler2D {0}bitangent;
out vec4 {0}value;
#line 1
{1}
void main() {{
  ivec2 {0}at = ivec2(gl_FragCoord.xy);
  {0}value = vec4(brdf(texelFetch({0}light, {0}at, 0).xyz, texelFetch({0}view, {0}at, 0).xyz,
                       texelFetch({0}normal, {0}at, 0).xyz, texelFetch({0}tangent, {0}at, 0).xyz,
                       texelFetch({0}bitangent, {0}at, 0).xyz), 1.0);
}}
)";

std::string unused_prefix(std::string_view source) {
  for (uint32_t number = 0;; ++number) {
    std::string prefix = fmt::format("host{}_", number);
    if (source.find(prefix) == std::string_view::npos) return prefix;
  }
}

std::string_view template_of(GeometrySource geometry) {
  switch (geometry) {
    case GeometrySource::Sphere:
      return kSphereTemplate;
    case GeometrySource::Table:
      return kTableTemplate;
  }
  return {};
}

}  // namespace

ShaderText shader_text(std::string_view source, GeometrySource geometry) {
  const std::string prefix = unused_prefix(source);
  return {fmt::format(fmt::runtime(template_of(geometry)), prefix, source), prefix};
}

const char* vertex_shader_text() {
  return R"(#version 330 core
#extension GL_ARB_separate_shader_objects : require
out gl_PerVertex { vec4 gl_Position; };
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = vec4(corner * 4.0 - 1.0, 0.0, 1.0);
}
)";
}

}  // namespace texbrdf::render
