// Emitted code is legal GLSL wherever it is pasted, and formatted, for models, random documents, random graphs, and
// documents made to provoke trouble.

#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "analysis/document.h"
#include "emit/emit.h"
#include "glsl_validator.h"
#include "support/program_of_graph.h"
#include "support/random_document.h"
#include "support/random_graph.h"
#include "support/read_file.h"

namespace texbrdf::test {
namespace {

constexpr std::size_t kLineWidth = 99;

ir::Program program_of(const std::string& text) {
  Document document(text);
  for (const Diagnostic& diagnostic : document.snapshot().diagnostics()) {
    if (diagnostic.severity == Severity::Error) throw std::runtime_error(message(diagnostic) + "\n" + text);
  }
  Result<ir::Program> program = document.snapshot().program();
  if (!program) throw std::runtime_error(program.error());
  return *std::move(program);
}

/// Everybody's lines are there, before those of the next.
std::string faults_of_lines(const emit::EmittedCode& code) {
  const auto count = static_cast<uint32_t>(std::ranges::count(code.text, '\n'));
  uint32_t next = 0;
  for (const emit::CodeLines& lines : code.lines) {
    if (lines.first < next || lines.last < lines.first || lines.last >= count) {
      return "lines " + std::to_string(lines.first) + " to " + std::to_string(lines.last) + "\n" + code.text;
    }
    next = lines.last + 1;
  }
  return "";
}

std::string emit_as(const ir::Program& program, std::string_view target,
                    emit::ParameterStyle style = emit::ParameterStyle::Constant) {
  Result<emit::EmittedCode> code = emit::find_target(target)->emit(program, {.parameters = style});
  if (!code) throw std::runtime_error(code.error());
  EXPECT_EQ(faults_of_lines(*code), "");
  return std::move(code->text);
}

/// Plain ASCII, short lines, no space at their ends, never two empty ones.
std::string faults_of_format(const std::string& code) {
  std::istringstream lines(code);
  std::string before = "-";
  int number = 0;
  for (std::string line; std::getline(lines, line); before = line) {
    std::string at = "line " + std::to_string(++number) + ": " + line + "\n";
    if (line.size() > kLineWidth) return "too long, " + at;
    if (line.ends_with(' ') || line.ends_with('\\')) return "bad end, " + at;
    if (line.empty() && before.empty()) return "two empty lines, " + at;
    for (char c : line)
      if (c < ' ' || c > '~') return "not ASCII, " + at;
  }
  return code.ends_with('\n') ? "" : "no line end at the end\n";
}

/// What the loader of Disney BRDF Explorer trips over.
std::string faults_of_brdf_file(const std::string& file) {
  if (!file.starts_with("analytic\n")) return "the first word is not `analytic`\n";
  std::istringstream lines(file);
  std::vector<std::string> sections;
  for (std::string line; std::getline(lines, line);) {
    std::size_t start = line.find_first_not_of(' ');
    if (start == std::string::npos) continue;
    if (line[start] == '#') return "a line that would be dropped: " + line + "\n";
    if (line.substr(start).starts_with("::")) sections.push_back(line.substr(start));
  }
  std::vector<std::string> expected{"::begin parameters", "::end parameters", "::begin shader", "::end shader"};
  if (sections != expected) return "other sections than parameters and shader\n";
  for (std::string_view word : {"discard", "dFdx", "dFdy"})
    if (brdf_shader(file).find(std::string(word) + "(") != std::string::npos) return std::string(word) + " is used\n";
  return "";
}

void expect_good_code(const ir::Program& program) {
  const std::string constant = emit_as(program, "glsl");
  const std::string uniform = emit_as(program, "glsl", emit::ParameterStyle::Uniform);
  const std::string brdf = emit_as(program, "disney");
  EXPECT_EQ(faults_of_glsl(constant), "");
  EXPECT_EQ(faults_of_glsl(uniform), "");
  EXPECT_EQ(faults_of_brdf(brdf), "");
  EXPECT_EQ(faults_of_brdf_file(brdf), "");
  EXPECT_EQ(faults_of_format(constant), "");
  EXPECT_EQ(faults_of_format(uniform), "");
  EXPECT_EQ(faults_of_format(brdf), "");
  EXPECT_EQ(emit_as(program, "glsl"), constant) << "not the same again";
  EXPECT_EQ(emit_as(program, "disney"), brdf) << "not the same again";
}

std::string equation(const std::string& text) {
  return "\\begin{equation}\n" + text + "\n\\end{equation}\n";
}

TEST(EmittedCode, OfModelsIsLegal) {
  for (const auto& entry : std::filesystem::directory_iterator(TEXBRDF_TEST_DATA "/models")) {
    if (entry.path().extension() != ".tex") continue;
    SCOPED_TRACE(entry.path().string());
    expect_good_code(program_of(read_file(entry.path())));
  }
}

TEST(EmittedCode, OfRandomDocumentsIsLegal) {
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    const std::string text = random_document(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + text);
    expect_good_code(program_of(text));
    if (HasFailure()) return;
  }
}

TEST(EmittedCode, OfRandomGraphsIsLegal) {
  const RandomGraphOptions options;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    expect_good_code(program_of_graph(random_graph(seed, options), options.parameters));
    if (HasFailure()) return;
  }
}

TEST(EmittedCode, AvoidsWordsOfTheLanguageAndItsHosts) {
  const std::vector<std::string> words{"sin",
                                       "mix",
                                       "float",
                                       "vec3",
                                       "discard",
                                       "main",
                                       "brdf",
                                       "BRDF",
                                       "gl\\_Position",
                                       "a\\_\\_b",
                                       "sampler2D",
                                       "half",
                                       "input",
                                       "gamma",
                                       "Sqr",
                                       "hash",
                                       "envLight",
                                       "esTheta",
                                       "tsX",
                                       "myPDF",
                                       "rand",
                                       "incidentVector",
                                       "L",
                                       "V",
                                       "N",
                                       "X",
                                       "Y",
                                       "H",
                                       "power",
                                       "square",
                                       "t",
                                       "k",
                                       "cos\\_theta\\_h",
                                       "9lives",
                                       "_",
                                       "\xC3\xA9t\xC3\xA9",
                                       "a b",
                                       "texture",
                                       "precise",
                                       "patch",
                                       "PI\\_",
                                       "thickness"};
  std::string text;
  std::string sum = "f = \\cos{\\theta_h}^3 + \\vec{h} \\cdot \\vec{n}";
  for (const std::string& word : words) {
    text += equation("\\text{" + word + "} = 0.5") + equation("\\vec{\\text{" + word + "}}(x, \\text{" + word +
                                                              "}) = x + \\text{" + word + "} * \\cos\\theta_h^2");
    sum += " + \\text{" + word + "} + \\vec{\\text{" + word + "}}(2, \\text{" + word + "})";
  }
  expect_good_code(program_of(text + equation(sum)));
}

TEST(EmittedCode, KeepsNamesApartThatLookAlike) {
  expect_good_code(program_of(equation("a_1 = 0.5") + equation("\\vec{a_1} = \\vec{1, 2, 3}") +
                              equation("\\text{a\\_1} = 3") + equation("\\vec{\\text{a\\_1}}(x) = x + a_1") +
                              equation("f = \\vec{a_1} * (a_1 + \\text{a\\_1} + \\vec{\\text{a\\_1}}(a_1))")));
}

TEST(EmittedCode, OfDeepExpressionsHasShortLines) {
  std::string nested = "x";
  for (int i = 0; i < 150; ++i) nested = "\\frac{1}{1 + \\sin(" + nested + ")}";
  std::string row = "x";
  for (int i = 0; i < 900; ++i) row += (i % 3 == 0 ? " - x" : " + x * 0.5");
  expect_good_code(program_of(equation("x = \\vec{n} \\cdot \\omega_i") + equation("a = " + nested) +
                              equation("b = " + row) + equation("f = a + b")));
}

TEST(EmittedCode, OfSharedValuesDoesNotExplode) {
  std::string text = equation("x = \\vec{n} \\cdot \\omega_i");
  std::string shared = "(x + 0.1)";
  for (int i = 0; i < 12; ++i) shared = "(" + shared + " * " + shared + " + 0.5)";
  ir::Program program = program_of(text + equation("f = " + shared));
  program.definitions.back().equation.clear();
  EXPECT_LT(emit_as(program, "glsl").size(), 5'000u);
  expect_good_code(program);
}

TEST(EmittedCode, OfLongChainsIsQuick) {
  std::string text = equation("a_0 = \\vec{n} \\cdot \\omega_i");
  for (int i = 1; i <= 10'000; ++i)
    text += equation("a_{" + std::to_string(i) + "} = a_{" + std::to_string(i - 1) + "} + 1");
  ir::Program program = program_of(text + equation("f = a_{10000}"));
  EXPECT_EQ(faults_of_format(emit_as(program, "glsl")), "");
}

TEST(EmittedCode, OfFunctionsThatUseTooMuchIsRefused) {
  std::string text = equation("a_0 = \\vec{n} \\cdot \\omega_i") + equation("g_0(x) = x");
  for (int i = 1; i <= 1000; ++i) {
    const std::string here = std::to_string(i);
    const std::string before = std::to_string(i - 1);
    text += equation("a_{" + here + "} = a_{" + before + "} * a_{" + before + "}");
    text += equation("g_{" + here + "}(x) = g_{" + before + "}(x) + a_{" + here + "}");
  }
  const ir::Program program = program_of(text + equation("f = g_{1000}(1)"));
  EXPECT_FALSE(emit::find_target("glsl")->emit(program, {}));
}

TEST(EmittedCode, IsNotDisturbedByEquationsInComments) {
  expect_good_code(program_of(equation("\\text{::end shader} = 0.5") +
                              equation("\\text{# no} = 1 + \\text{::end shader}") +
                              equation("f = \\text{# no} + \\text{*/ \\\\}* 2 + \\text{\xF0\x9F\x98\x80}") +
                              equation("\\text{*/ \\\\} = 2") + equation("\\text{\xF0\x9F\x98\x80} = 1 \\ ")));
}

}  // namespace
}  // namespace texbrdf::test
