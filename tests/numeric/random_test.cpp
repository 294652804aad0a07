// Random documents and graphs: no passes, all passes and batches agree.

#include <cstdio>

#include "ir/passes/passes.h"
#include "ir/passes/rewrite.h"
#include "model.h"
#include "support/random_document.h"
#include "support/random_graph.h"

namespace texbrdf::test {
namespace {

using eval::Geometry;
using eval::Triple;
using ir::Op;
using ir::ValueId;

constexpr int kDocuments = 150;
constexpr int kGraphs = 400;
constexpr std::size_t kGeometries = 150;  // more than a batch
constexpr int kNoisyGraphs = 8;
/// A few roundings of single precision.
constexpr double kNoise = 3e-7;
/// Where noise moves the result by more, a comparison stands on the edge, and nothing can be said.
constexpr double kFragile = 0.02;

/// Both directions above the horizon, half of them in a rotated frame.
std::vector<Geometry> random_geometries(Random& random) {
  std::vector<Geometry> result;
  while (result.size() < kGeometries) {
    const Geometry geometry{.light = random_direction(random, 0.05), .view = random_direction(random, 0.05)};
    result.push_back(in_single_precision(random.chance(0.5) ? geometry : Rotation(random)(geometry)));
  }
  return result;
}

bool is_rounded(const ir::Value& value) {
  return value.op != Op::Constant && value.op != Op::BoundVariable && value.type != Type::Boolean;
}

/// The graph with an error of about kNoise in every value that is computed: what an evaluation in single precision may
/// do to it. The opposite `noise` gives the opposite errors.
ir::Graph with_noise(const ir::Graph& unexpanded, Random random, double noise) {
  const ir::Graph graph = ir::expand_conventions(unexpanded);
  return ir::rewrite(graph, [&](ir::Graph& result, ValueId id, std::span<const ValueId> operands) {
    const ValueId exact = result.copy(graph.at(id), operands);
    if (!is_rounded(graph.at(id))) return exact;
    const ValueId scale = result.constant(1 + noise * random.real(-1, 1));
    const ValueId offset = result.constant(noise * random.real(-1, 1));
    return result.add(Op::Add, {result.add(Op::Multiply, {exact, scale}), offset});
  });
}

std::vector<Triple> in_double(const ir::Graph& graph, const std::vector<Triple>& parameters,
                              const std::vector<Geometry>& geometries) {
  const eval::ReferenceEvaluator evaluator(graph);
  std::vector<Triple> values;
  for (const Geometry& geometry : geometries) values.push_back(evaluator.evaluate(geometry, parameters));
  return values;
}

/// How far noise moves each result; NaN or infinity where it decides between a number and none.
std::vector<double> sensitivities(const ir::Graph& graph, const std::vector<Triple>& parameters,
                                  const std::vector<Geometry>& geometries, const std::vector<Triple>& exact,
                                  uint64_t seed) {
  std::vector<double> result(geometries.size(), 0);
  for (unsigned i = 0; i < kNoisyGraphs; ++i) {
    const std::vector<Triple> noisy =
        in_double(with_noise(graph, Random(seed + i / 2), i % 2 == 0 ? kNoise : -kNoise), parameters, geometries);
    for (std::size_t g = 0; g < geometries.size(); ++g) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double moved = std::abs(noisy[g][c] - exact[g][c]);
        if (!(moved <= result[g])) result[g] = moved;
      }
    }
  }
  return result;
}

/// Counts what could be compared: a test that compares nothing cannot fail.
struct Coverage {
  std::size_t compared = 0;
  std::size_t fragile = 0;
};

void expect_agreement(const ir::Graph& graph, const std::vector<Triple>& parameters, uint64_t seed,
                      Coverage& coverage) {
  Random random(seed);
  const ir::Graph optimised = ir::run_passes(graph, ir::evaluation_passes());
  const std::vector<Geometry> geometries = random_geometries(random);
  const std::vector<Triple> exact = in_double(graph, parameters, geometries);
  const std::vector<double> moved = sensitivities(graph, parameters, geometries, exact, seed);
  const auto expect_close = [&](const std::vector<Triple>& actual, double precision, const std::string& what) {
    // Of the noise in single precision, that of this precision.
    const double share = precision / kNoise;
    for (std::size_t i = 0; i < geometries.size(); ++i) {
      if (!(moved[i] <= kFragile)) continue;
      Deviation deviation(100 * precision, 100 * precision + 8 * share * moved[i]);
      deviation.compare(actual[i], exact[i], what);
      EXPECT_LE(deviation.share(), 1) << deviation.first_failure() << " where noise moves it by " << moved[i];
    }
  };
  expect_close(in_double(optimised, parameters, geometries), 1e-14, "after passes");
  for (const eval::Backend& backend : eval::backends()) {
    for (const ir::Graph* one : {&graph, &optimised}) {
      const eval::BatchEvaluator evaluator(*one, backend.set, *backend.functions);
      expect_close(evaluate_batch(evaluator, geometries, parameters), kNoise,
                   backend.name + (one == &graph ? "" : " after passes"));
    }
  }
  for (const double m : moved) ++(m <= kFragile ? coverage.compared : coverage.fragile);
}

void expect_covered(const Coverage& coverage) {
  std::printf("compared %zu, left out as fragile %zu\n", coverage.compared, coverage.fragile);
  EXPECT_GT(coverage.compared, 9 * coverage.fragile);
}

TEST(Random, DocumentsHaveOneValueByAllWays) {
  Coverage coverage;
  for (uint64_t seed = 1; seed <= kDocuments; ++seed) {
    const std::string text = RandomDocument(seed, {}).make();
    const Result<eval::CompiledModel> model = compile_text(text);
    ASSERT_TRUE(model) << model.error() << "\nseed " << seed << "\n" << text;
    expect_agreement(model->unoptimised, model->parameters, seed, coverage);
    if (HasFailure()) FAIL() << "seed " << seed << "\n" << text;
  }
  expect_covered(coverage);
}

TEST(Random, GraphsHaveOneValueByAllWays) {
  const std::vector<Triple> parameters = {{0.3, 0.3, 0.3}, {0.2, 0.9, 0.5}};
  Coverage coverage;
  for (uint64_t seed = 1; seed <= kGraphs; ++seed) {
    expect_agreement(random_graph(seed), parameters, seed, coverage);
    if (HasFailure()) FAIL() << "seed " << seed;
  }
  expect_covered(coverage);
}

}  // namespace
}  // namespace texbrdf::test
