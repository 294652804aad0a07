#include "glsl_validator.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

#include <sstream>

namespace texbrdf::test {
namespace {

/// glslang wants to be started once in a process.
const bool kStarted = glslang::InitializeProcess();

constexpr const char* kMainFragment =
    "in vec3 light_;\nin vec3 view_;\nout vec4 colour_;\n"
    "void main() {\n  colour_ = vec4(ENTRY(light_, view_, vec3(0.0, 0.0, 1.0), vec3(1.0, 0.0, 0.0), "
    "vec3(0.0, 1.0, 0.0)), 1.0);\n}\n";
constexpr const char* kMainVertex =
    "in vec3 light_;\nin vec3 view_;\n"
    "void main() {\n  gl_Position = vec4(ENTRY(light_, view_, vec3(0.0, 0.0, 1.0), vec3(1.0, 0.0, 0.0), "
    "vec3(0.0, 1.0, 0.0)), 1.0);\n}\n";

std::string with_entry(std::string text, const std::string& entry) {
  return text.replace(text.find("ENTRY"), 5, entry);
}

/// Some of the names that the program's own templates define around a shader.
constexpr const char* kExplorerTemplate =
    "uniform float gamma;\nuniform float exposure;\nuniform vec3 incidentVector;\nuniform float incidentTheta;\n"
    "uniform sampler2D probTex;\nuniform mat3 normalMatrix;\nconst float PI_ = 3.14159265;\n"
    "float Sqr(float x) { return x * x; }\nfloat hash(float n) { return fract(n); }\nfloat rand(vec2 s) { return s.x; }\n"
    "vec3 RGB2L(vec3 c) { return c; }\nfloat envSample(float x) { return x; }\nfloat esTheta;\nfloat tsTheta;\n";

struct BrdfSections {
  std::string uniforms;
  std::string shader;
};

BrdfSections read_brdf(const std::string& file) {
  BrdfSections sections;
  std::string section;
  std::istringstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string first;
    std::string second;
    words >> first >> second;
    if (first == "::begin") {
      section = second;
    } else if (first == "::end") {
      section.clear();
    } else if (first.empty() || first.front() == '#') {
      continue;
    } else if (section == "parameters") {
      sections.uniforms += "uniform " + std::string(first == "color" ? "vec3" : first) + " " + second + ";\n";
    } else if (section == "shader") {
      sections.shader += line + "\n";
    }
  }
  return sections;
}

}  // namespace

std::string faults_of_shader(const std::string& source, ShaderStage stage) {
  glslang::TShader shader(stage == ShaderStage::Vertex ? EShLangVertex : EShLangFragment);
  const char* text = source.c_str();
  shader.setStrings(&text, 1);
  bool parsed = kStarted && shader.parse(GetDefaultResources(), 330, false, EShMsgDefault);
  return parsed ? "" : std::string(shader.getInfoLog()) + "\n" + source;
}

std::string faults_of_glsl(const std::string& code) {
  std::string main = with_entry(kMainFragment, "brdf");
  return faults_of_shader("#version 330 core\n" + code + main, ShaderStage::Fragment) +
         faults_of_shader("#version 300 es\nprecision highp float;\n" + code + main, ShaderStage::Fragment);
}

std::string faults_of_brdf(const std::string& file) {
  BrdfSections sections = read_brdf(file);
  std::string start = "#version 410 core\n" + sections.uniforms + kExplorerTemplate + sections.shader;
  return faults_of_shader(start + with_entry(kMainVertex, "BRDF"), ShaderStage::Vertex) +
         faults_of_shader(start + with_entry(kMainFragment, "BRDF"), ShaderStage::Fragment);
}

std::string brdf_shader(const std::string& file) {
  return read_brdf(file).shader;
}

}  // namespace texbrdf::test
