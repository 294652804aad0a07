#pragma once

#include <string>

namespace texbrdf::test {

enum class ShaderStage : unsigned char { Vertex, Fragment };

/// What glslang says against a complete shader; empty where it is legal.
std::string faults_of_shader(const std::string& source, ShaderStage stage);

/// The same for code of the target `glsl`, pasted into a fragment shader of GLSL 330 and of ESSL 300.
std::string faults_of_glsl(const std::string& code);
/// The same for a .brdf file, whose parameters and shader are put into a GLSL 410 shader as Disney BRDF Explorer does,
/// in the vertex and in the fragment stage.
std::string faults_of_brdf(const std::string& file);

/// The shader section of a .brdf file as the program reads it: lines that begin with # are dropped.
std::string brdf_shader(const std::string& file);

}  // namespace texbrdf::test
