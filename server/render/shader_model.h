#pragma once

#include <array>
#include <string>
#include <vector>

namespace texbrdf::render {

/// A parameter of a shader.
struct Uniform {
  std::string name;
  uint32_t components = 1;  ///< 1 or 3
  std::array<float, 3> value{};
};

/// GLSL that defines `vec3 brdf(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y)`, without `#version` and without `main`,
/// and the values of its uniforms. Other values of the same source need no compilation.
struct ShaderModel {
  std::string source;
  std::vector<Uniform> uniforms;
};

}  // namespace texbrdf::render
