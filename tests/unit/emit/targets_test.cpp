// What the targets promise beside legal code.

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "emit/emit.h"
#include "support/linkable_document.h"

namespace texbrdf::emit {
namespace {

std::string equation(const std::string& text) {
  return "\\begin{equation}\n" + text + "\n\\end{equation}\n";
}

std::string emit_as(std::string_view target, const std::string& text, const EmitOptions& options = {}) {
  Result<ir::Program> program = test::LinkableDocument(text).link();
  if (!program) return program.error();
  Result<EmittedCode> code = find_target(target)->emit(*program, options);
  return code ? code->text : code.error();
}

/// The lines between two lines.
std::string section(const std::string& file, const std::string& first, const std::string& last) {
  std::size_t begin = file.find(first + "\n");
  std::size_t end = file.find(last + "\n");
  if (begin == std::string::npos || end == std::string::npos) return "no section " + first;
  begin += first.size() + 1;
  return file.substr(begin, end - begin);
}

/// Each name with lines of its own, and those lines.
std::string lines_of(std::string_view target, const std::string& text, ParameterStyle style = {}) {
  const ir::Program program = *test::LinkableDocument(text).link();
  const EmittedCode code = *find_target(target)->emit(program, {.parameters = style});
  std::map<NameId, std::string> names;
  for (const ir::Parameter& parameter : program.parameters) names[parameter.id] = parameter.canonical;
  for (const ir::ProgramDefinition& definition : program.definitions) names[definition.id] = definition.canonical;
  std::vector<std::string> rows;
  std::istringstream stream(code.text);
  for (std::string row; std::getline(stream, row);) rows.push_back(row);
  std::string out;
  for (const CodeLines& lines : code.lines) {
    out += names.at(lines.name) + ":\n";
    for (uint32_t row = lines.first; row <= lines.last; ++row) out += rows.at(row) + "\n";
  }
  return out;
}

const std::string kShared = equation("m = 0.5") + equation("\\rho_d = \\vec{0.3, 0.05, 1}") +
                            equation("g(x) = m * x^2") + equation("a = \\cos\\theta_h + m") +
                            equation("f = \\rho_d * g(a) + \\vec{1, 1, 1} * a * \\pi");

const std::string kParameters = equation("m = 0.13 % range [0.01, 1]") + equation("L = 0.1") +
                                equation("\\rho_d = \\vec{0.3, 0.05, 1}") + equation("\\gamma = 2e-7");
const std::string kDocument = kParameters + equation("f = \\rho_d * (m + L + \\gamma)");

TEST(Targets, AreFoundByName) {
  ASSERT_NE(find_target("glsl"), nullptr);
  ASSERT_NE(find_target("disney"), nullptr);
  EXPECT_EQ(find_target("disney")->extension, ".brdf");
  EXPECT_EQ(find_target("cobol"), nullptr);
  for (const Target& target : targets()) EXPECT_EQ(find_target(target.name), &target);
}

TEST(Glsl, TellsWhoseEachLineIs) {
  EXPECT_EQ(lines_of("glsl", kShared),
            "g:\n"
            "// g(x) = m * x^2\n"
            "float g(float x, float m) {\n"
            "  return m * x * x;\n"
            "}\n"
            "\\rho_d:\n"
            "  const vec3 rho_d = vec3(0.3, 0.05, 1.0);\n"
            "m:\n"
            "  const float m = 0.5;\n"
            "a:\n"
            "  // a = \\cos\\theta_h + m\n"
            "  float a = cos_theta_h + m;\n"
            "f:\n"
            "  // f = \\rho_d * g(a) + \\vec{1, 1, 1} * a * \\pi\n"
            "  return rho_d * g(a, m) + vec3(1.0, 1.0, 1.0) * a * pi;\n");
}

TEST(Glsl, TellsTheLinesOfUniforms) {
  EXPECT_EQ(lines_of("glsl", equation("m = 0.5") + equation("f = m"), ParameterStyle::Uniform),
            "m:\n"
            "uniform float m;  // range [0, 1], default 0.5\n"
            "f:\n"
            "  // f = m\n"
            "  return vec3(m);\n");
}

TEST(Disney, TellsWhoseEachLineIs) {
  EXPECT_EQ(lines_of("disney", kShared),
            "\\rho_d:\n"
            "color rho_d 0.3 0.05 1\n"
            "m:\n"
            "float m 0 1 0.5\n"
            "g:\n"
            "// g(x) = m * x^2\n"
            "float g(float x) {\n"
            "  return m * x * x;\n"
            "}\n"
            "a:\n"
            "  // a = \\cos\\theta_h + m\n"
            "  float a = cos_theta_h + m;\n"
            "f:\n"
            "  // f = \\rho_d * g(a) + \\vec{1, 1, 1} * a * \\pi\n"
            "  return rho_d * g(a) + vec3(1.0, 1.0, 1.0) * a * pi;\n");
}

TEST(Disney, BeginsWithItsFirstWord) {
  EXPECT_TRUE(emit_as("disney", kDocument).starts_with("analytic\n"));
}

TEST(Disney, ListsParametersWithTheirRanges) {
  EXPECT_EQ(section(emit_as("disney", kDocument), "::begin parameters", "::end parameters"),
            "color rho_d 0.3 0.05 1\nfloat m 0.01 1 0.13\nfloat L_2 0 1 0.1\nfloat gamma_ 0 1 2e-7\n");
}

TEST(Disney, ParametersReadBackToTheSameSingle) {
  for (const std::string number : {"0.1", "0.7071067811865476", "1e-12", "123456.789"}) {
    std::istringstream words(section(emit_as("disney", equation("m = " + number) + equation("f = m")),
                                     "::begin parameters", "::end parameters"));
    std::string type, name, least, most, value;
    words >> type >> name >> least >> most >> value;
    EXPECT_EQ(type, "float");
    EXPECT_EQ(std::strtof(value.c_str(), nullptr), std::strtof(number.c_str(), nullptr)) << number;
  }
}

TEST(Disney, ParametersAreNoLocals) {
  EXPECT_EQ(emit_as("disney", kDocument).find("const float m"), std::string::npos);
}

TEST(Disney, IsZeroBelowTheHorizonOfTheGivenNormal) {
  const std::string shader = section(emit_as("disney", kDocument), "::begin shader", "::end shader");
  EXPECT_NE(shader.find("vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {\n"
                        "  if (dot(N, L) <= 0.0 || dot(N, V) <= 0.0) return vec3(0.0);\n"),
            std::string::npos)
      << shader;
}

TEST(Disney, HasOneSectionOfEachKind) {
  const std::string file = emit_as("disney", kDocument);
  for (const std::string word : {"::begin parameters", "::end parameters", "::begin shader", "::end shader"})
    EXPECT_EQ(file.find(word), file.rfind(word)) << word;
}

TEST(Glsl, GivesTheRawValue) {
  EXPECT_EQ(emit_as("glsl", kDocument).find("if ("), std::string::npos);
}

TEST(Glsl, IsToBePasted) {
  EXPECT_EQ(emit_as("glsl", kDocument).find('#'), std::string::npos);
}

TEST(Glsl, ParametersAreConstantLocals) {
  const std::string code = emit_as("glsl", kDocument);
  EXPECT_NE(code.find("  const float m = 0.13;\n"), std::string::npos);
  EXPECT_NE(code.find("  const vec3 rho_d = vec3(0.3, 0.05, 1.0);\n"), std::string::npos);
  EXPECT_NE(code.find("  const float gamma = 2.0e-7;\n"), std::string::npos);
}

TEST(Glsl, ParametersAreUniformsOnRequest) {
  const std::string code = emit_as("glsl", kDocument, {.parameters = ParameterStyle::Uniform});
  EXPECT_NE(code.find("uniform vec3 rho_d;  // range [0, 1], default 0.3 0.05 1\n"
                      "uniform float m;  // range [0.01, 1], default 0.13\n"
                      "uniform float L_2;  // range [0, 1], default 0.1\n"),
            std::string::npos)
      << code;
  EXPECT_EQ(code.find("const float m"), std::string::npos);
}

TEST(Glsl, TellsHostsTheNamesOfItsUniforms) {
  const ir::Program program = *test::LinkableDocument(kDocument).link();
  EXPECT_EQ(parameter_identifiers(program), (std::vector<std::string>{"rho_d", "m", "L_2", "gamma"}));
}

TEST(Glsl, PassesParametersToFunctions) {
  const std::string text = kParameters + equation("g(x) = x * m") + equation("f = g(2)");
  EXPECT_NE(emit_as("glsl", text).find("float g(float x, float m) {"), std::string::npos);
  EXPECT_NE(emit_as("glsl", text, {.parameters = ParameterStyle::Uniform}).find("float g(float x) {"),
            std::string::npos);
}

TEST(Glsl, ReturnsGreyForARealRoot) {
  EXPECT_NE(emit_as("glsl", equation("f = 1 + 1")).find("  return vec3(2.0);\n"), std::string::npos);
}

}  // namespace
}  // namespace texbrdf::emit
