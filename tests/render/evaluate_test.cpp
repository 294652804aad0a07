#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "eval/evaluate.h"
#include "support.h"
#include "support/paper_documents.h"
#include "support/random_document.h"

// The emitted GLSL on the GPU against the double reference, which reads the graph before any pass: a wrong pass
// differs.

namespace texbrdf {
namespace {

using eval::Geometry;
using eval::Triple;

std::vector<Geometry> read_directions(const std::string& path) {
  std::istringstream lines(test::read_file(path));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line.substr(0, 17), "Lx,Ly,Lz,Vx,Vy,Vz");
  std::vector<Geometry> geometries;
  while (std::getline(lines, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream numbers(line);
    Geometry geometry;
    for (double& x : geometry.light) numbers >> x;
    for (double& x : geometry.view) numbers >> x;
    geometries.push_back(geometry);
  }
  return geometries;
}

std::vector<Geometry> directions_of(const std::string& model) {
  return read_directions(test::model_path(model, ".csv"));
}

/// By the unit quaternion (1, 2, -3, 5)/√39: no axis stays where it is.
Triple rotated(const Triple& v) {
  constexpr double w = 1, x = 2, y = -3, z = 5, norm = w * w + x * x + y * y + z * z;
  return {((w * w + x * x - y * y - z * z) * v[0] + 2 * (x * y - w * z) * v[1] + 2 * (x * z + w * y) * v[2]) / norm,
          (2 * (x * y + w * z) * v[0] + (w * w - x * x + y * y - z * z) * v[1] + 2 * (y * z - w * x) * v[2]) / norm,
          (2 * (x * z - w * y) * v[0] + 2 * (y * z + w * x) * v[1] + (w * w - x * x - y * y + z * z) * v[2]) / norm};
}

Geometry rotated(const Geometry& g) {
  return {rotated(g.light), rotated(g.view), rotated(g.normal), rotated(g.tangent), rotated(g.bitangent)};
}

/// GPUs have no exact inverse trigonometric functions: 1.6e-4 and 3.9e-4 off on llvmpipe.
double relative_tolerance(const std::string& shader) {
  for (const char* function : {"acos(", "asin(", "atan("}) {
    if (shader.find(function) != std::string::npos) return 3e-3;
  }
  return 1e-3;
}

struct Deviation {
  double relative = 0;  ///< the largest of (|Δ| − 1e-6) / |ref|
  double absolute = 0;  ///< the largest |Δ|
  int wrong_nan = 0;
};

Deviation deviation(render::RenderWorker& worker, const ir::Program& program, const render::ShaderModel& shader,
                    const std::vector<Geometry>& geometries) {
  const auto graph = ir::flatten(program);
  EXPECT_TRUE(graph) << graph.error();
  const eval::ReferenceEvaluator reference(*graph);
  std::vector<Triple> parameters;
  for (const ir::Parameter& parameter : program.parameters) parameters.push_back(parameter.value);
  const auto result = worker.evaluate(shader, geometries);
  const auto* fault = std::get_if<render::RenderFault>(&result);
  EXPECT_EQ(fault, nullptr) << fault->message;
  if (fault != nullptr) return {INFINITY, INFINITY, 0};

  Deviation worst;
  const auto& values = std::get<0>(result);
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    const Triple expected = reference.evaluate(geometries[i], parameters);
    for (std::size_t c = 0; c < 3; ++c) {
      const double got = static_cast<double>(values[i][c]);
      if (std::isnan(got) != std::isnan(expected[c])) ++worst.wrong_nan;
      if (got == expected[c] || std::isnan(got) || std::isnan(expected[c])) continue;
      worst.absolute = std::max(worst.absolute, std::abs(got - expected[c]));
      const double excess = std::abs(got - expected[c]) - 1e-6;
      if (excess > 0) worst.relative = std::max(worst.relative, excess / std::abs(expected[c]));
    }
  }
  return worst;
}

void expect_agreement(const ir::Program& program, const std::vector<Geometry>& geometries) {
  const auto shader = preview::shader_model(program);
  ASSERT_TRUE(shader) << shader.error();
  render::RenderWorker worker(test::worker_options());
  const Deviation worst = deviation(worker, program, *shader, geometries);
  EXPECT_LE(worst.relative, relative_tolerance(shader->source));
  EXPECT_EQ(worst.wrong_nan, 0);
  testing::Test::RecordProperty("relative_deviation", std::to_string(worst.relative));
}

class Evaluated : public testing::TestWithParam<std::string> {};

TEST_P(Evaluated, AgreesWithTheReferenceInTheStandardFrame) {
  expect_agreement(test::model_program(GetParam()), directions_of(GetParam()));
}

TEST_P(Evaluated, AgreesWithTheReferenceInARotatedFrame) {
  std::vector<Geometry> geometries = directions_of(GetParam());
  for (Geometry& geometry : geometries) geometry = rotated(geometry);
  expect_agreement(test::model_program(GetParam()), geometries);
}

INSTANTIATE_TEST_SUITE_P(Models, Evaluated, testing::ValuesIn(test::model_names()), test::test_name);

/// Fresnel's equations in terms of angles: near normal incidence, quotients of differences of angles, of which the
/// inverse functions of llvmpipe leave no digit. In single precision on the CPU it agrees.
constexpr std::string_view kIllConditioned = "publications/wolff-1994";

std::vector<std::string> papers_for_gpu() {
  std::vector<std::string> names = test::paper_documents();
  std::erase(names, kIllConditioned);
  return names;
}

class EvaluatedPaper : public testing::TestWithParam<std::string> {};

TEST_P(EvaluatedPaper, AgreesWithTheReference) {
  const std::string path = std::string(TEXBRDF_TEST_DATA) + "/" + GetParam();
  Document document(test::read_file(path + ".tex"));
  const Result<ir::Program> program = document.snapshot().program();
  ASSERT_TRUE(program) << program.error();
  expect_agreement(*program, read_directions(path + ".csv"));
}

INSTANTIATE_TEST_SUITE_P(All, EvaluatedPaper, testing::ValuesIn(papers_for_gpu()),
                         [](const auto& test) { return test::paper_test_name(test.param); });

/// Values of random documents are of the size of 1, and full of inverse trigonometric functions.
TEST(Evaluate, RandomDocumentsAgreeWithTheReference) {
  constexpr double kTolerance = 6e-3;
  render::RenderWorker worker(test::worker_options());
  const std::vector<Geometry> geometries = directions_of("conventions");
  for (uint64_t seed = 1; seed <= 25; ++seed) {
    const std::string text = test::random_document(seed);
    const auto program = test::program_of(text);
    ASSERT_TRUE(program) << program.error() << '\n' << text;
    const auto shader = preview::shader_model(*program);
    ASSERT_TRUE(shader) << shader.error();
    const Deviation worst = deviation(worker, *program, *shader, geometries);
    EXPECT_LE(worst.absolute, kTolerance) << "seed " << seed << '\n' << text << shader->source;
    EXPECT_EQ(worst.wrong_nan, 0) << "seed " << seed;
  }
}

TEST(Evaluate, RotationKeepsTheFrameOrthonormal) {
  const Geometry g = rotated(Geometry{{0, 0, 1}, {0, 0, 1}});
  for (const Triple& v : {g.normal, g.tangent, g.bitangent}) {
    EXPECT_NEAR(v[0] * v[0] + v[1] * v[1] + v[2] * v[2], 1, 1e-15);
  }
  EXPECT_NEAR(g.tangent[0] * g.bitangent[1] - g.tangent[1] * g.bitangent[0], g.normal[2], 1e-15);
}

TEST(Evaluate, TakesMoreGeometriesThanOneRequestHolds) {
  const render::ShaderModel sum{
      "vec3 brdf(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { return vec3(L.x, V.y, N.x + X.y + Y.z); }\n", {}};
  std::vector<Geometry> geometries(150'001);
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    const auto x = static_cast<double>(i);
    geometries[i] = {{x, 0, 0}, {0, -x, 0}, {x, 0, 0}, {0, 2, 0}, {0, 0, 1}};
  }
  render::RenderWorker worker(test::worker_options());
  const auto result = worker.evaluate(sum, geometries);
  const auto* values = std::get_if<0>(&result);
  ASSERT_NE(values, nullptr) << std::get<1>(result).message;
  ASSERT_EQ(values->size(), geometries.size());
  for (std::size_t i = 0; i < geometries.size(); i += 997) {
    const auto x = static_cast<float>(i);
    EXPECT_EQ((*values)[i], (std::array<float, 3>{x, -x, x + 3}));
  }
}

TEST(Evaluate, NothingIsAnsweredWithNothing) {
  render::RenderWorker worker(test::worker_options());
  const auto result = worker.evaluate({}, {});
  ASSERT_EQ(result.index(), 0U);
  EXPECT_TRUE(std::get<0>(result).empty());
}

}  // namespace
}  // namespace texbrdf
