#include "eval/batch.h"

#include <thread>

#include "eval/compile.h"
#include "eval/tape.h"
#include "ir/passes/passes.h"
#include "source/internal_error.h"
#include "support/evaluation.h"

namespace texbrdf::eval {
namespace {

using ir::Graph;
using ir::Op;
using ir::ValueId;

/// (L·V)·p + Nx: needs the geometry and a parameter.
Graph small_graph() {
  Graph graph;
  const ValueId dot = graph.add(Op::Dot, {graph.convention(Convention::OmegaI), graph.convention(Convention::OmegaO)});
  const ValueId scaled = graph.add(Op::Multiply, {dot, graph.leaf(Op::Parameter, Type::Real, 0)});
  graph.roots = {graph.add(Op::Add, {scaled, graph.add(Op::Component, {graph.convention(Convention::Normal)}, 0)})};
  return graph;
}

std::vector<Geometry> numbered_geometries(std::size_t count) {
  std::vector<Geometry> geometries;
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = static_cast<double>(i);
    geometries.push_back({.light = {x, 1, 0}, .view = {1, 2, 3}, .normal = {-x, 0, 0}});
  }
  return geometries;
}

TEST(Batch, OfAnyCountWritesExactlyThatMany) {
  for (const Backend& backend : backends()) {
    const BatchEvaluator evaluator(small_graph(), backend.set);
    for (const std::size_t count : {0, 1, 3, 15, 16, 17, 127, 128, 129, 255, 256, 1000}) {
      const GeometryArrays arrays(numbered_geometries(count));
      std::vector<float> red(count + 1, -7), green(count + 1, -7), blue(count + 1, -7);
      evaluator.evaluate(arrays.batch(), std::vector<Triple>{{2, 2, 2}}, {red.data(), green.data(), blue.data()});
      for (std::size_t i = 0; i < count; ++i) {
        const auto expected = static_cast<float>(i) + 4;
        EXPECT_EQ(red[i], expected) << backend.name << " " << count << " " << i;
        EXPECT_EQ(green[i], expected);
        EXPECT_EQ(blue[i], expected);
      }
      EXPECT_EQ(red[count], -7);
      EXPECT_EQ(green[count], -7);
      EXPECT_EQ(blue[count], -7);
    }
  }
}

TEST(Batch, ReadsOnlyInputsThatTheGraphUses) {
  const GeometryArrays arrays(numbered_geometries(5));
  GeometryBatch batch = arrays.batch();
  batch.tangent = {nullptr, nullptr, nullptr};
  batch.bitangent = {nullptr, nullptr, nullptr};
  batch.normal[1] = nullptr;
  std::vector<float> out(5);
  BatchEvaluator(small_graph()).evaluate(batch, std::vector<Triple>{{1, 1, 1}}, {out.data(), out.data(), out.data()});
  EXPECT_EQ(out[3], 2);
}

TEST(Batch, OfAnInputAndOfAConstant) {
  Graph graph;
  graph.roots = {graph.convention(Convention::Bitangent), graph.constant(3)};
  std::vector<Geometry> geometries(130);
  geometries[129].bitangent = {5, 6, 7};
  const BatchEvaluator evaluator(graph);
  EXPECT_EQ(evaluate_batch(evaluator, geometries)[129], (Triple{5, 6, 7}));
  EXPECT_EQ(evaluate_batch(evaluator, geometries)[0], (Triple{0, 1, 0}));
  EXPECT_EQ(evaluate_batch(evaluator, geometries, {}, 1)[129], (Triple{3, 3, 3}));
}

TEST(Batch, ComputesOnceWhatDoesNotDependOnTheGeometry) {
  Graph graph;
  const ValueId p = graph.leaf(Op::Parameter, Type::Real, 0);
  const ValueId uniform = graph.add(Op::Exp, {graph.add(Op::Multiply, {p, p})});
  graph.roots = {graph.add(Op::Multiply, {uniform, graph.convention(Convention::OmegaI)})};
  const Tape tape = build_tape(graph);
  EXPECT_EQ(tape.prologue.size(), 2u);
  EXPECT_EQ(tape.body.size(), 3u);
}

TEST(Batch, KeepsFewSlots) {
  Graph graph;
  ValueId last = graph.add(Op::Component, {graph.convention(Convention::OmegaI)}, 0);
  for (int i = 0; i < 1000; ++i) last = graph.add(i % 2 == 0 ? Op::Sin : Op::Cos, {last});
  graph.roots = {last};
  EXPECT_LE(build_tape(graph).lane_slots, 2u);
}

TEST(Batch, LeavesOutComponentsThatNothingNeeds) {
  Graph graph;
  const ValueId cross =
      graph.add(Op::Cross, {graph.convention(Convention::OmegaI), graph.convention(Convention::OmegaO)});
  const ValueId product = graph.add(Op::Multiply, {cross, cross});
  graph.roots = {graph.add(Op::Component, {product}, 1)};
  EXPECT_EQ(build_tape(graph).body.size(), 2u);
}

TEST(Batch, WithMoreLiveValuesThanTheCacheHolds) {
  // 10 000 values that all live until the end: sum of sin(Lx + k).
  Graph graph;
  constexpr int kCount = 10'000;
  const ValueId x = graph.add(Op::Component, {graph.convention(Convention::OmegaI)}, 0);
  std::vector<ValueId> terms;
  for (int k = 0; k < kCount; ++k) terms.push_back(graph.add(Op::Add, {x, graph.constant(k)}));
  ValueId sum = graph.constant(0);
  for (const ValueId term : terms) sum = graph.add(Op::Add, {sum, graph.add(Op::Sin, {term})});
  graph.roots = {sum};
  EXPECT_GE(build_tape(graph).lane_slots, static_cast<uint32_t>(kCount));
  const std::vector<Geometry> geometries = numbered_geometries(200);
  const ReferenceEvaluator reference(graph);
  const std::vector<Triple> actual = evaluate_batch(BatchEvaluator(graph), geometries);
  for (std::size_t i = 0; i < geometries.size(); i += 37) {
    EXPECT_NEAR(actual[i][0], reference.evaluate(geometries[i], {})[0], 0.02);
  }
}

TEST(Batch, UnderstandsConventionsThatAreNotExpanded) {
  Graph graph;
  const ValueId light = graph.convention(Convention::OmegaI), normal = graph.convention(Convention::Normal);
  graph.roots = {graph.convention(Convention::ThetaI, std::vector<ValueId>{normal, light})};
  const Geometry geometry{.light = {std::sin(0.3), 0, std::cos(0.3)}, .view = {}};
  EXPECT_NEAR(evaluate_batch(BatchEvaluator(graph), {geometry})[0][0], 0.3, 1e-6);
}

TEST(Batch, IsSharedByThreads) {
  const Graph graph = small_graph();
  const BatchEvaluator batch(graph);
  const ReferenceEvaluator reference(graph);
  const std::vector<Geometry> geometries = numbered_geometries(500);
  const auto run = [&](double p, bool& right) {
    right = true;
    for (int repeat = 0; repeat < 20; ++repeat) {
      const std::vector<Triple> parameters = {{p, p, p}};
      const std::vector<Triple> actual = evaluate_batch(batch, geometries, parameters);
      for (std::size_t i = 0; i < geometries.size(); ++i) {
        right = right && is_close(actual[i][0], reference.evaluate(geometries[i], parameters)[0], 1e-6, 1e-6);
      }
    }
  };
  std::array<bool, 4> right{};
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < right.size(); ++i) {
    threads.emplace_back(run, static_cast<double>(i), std::ref(right[i]));
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(right, (std::array<bool, 4>{true, true, true, true}));
}

TEST(Batch, RefusesAMissingParameter) {
  EXPECT_THROW(evaluate_batch(BatchEvaluator(small_graph()), {Geometry{}}), InternalError);
  EXPECT_THROW(static_cast<void>(ReferenceEvaluator(small_graph()).evaluate({}, {})), InternalError);
}

TEST(ElementaryFunctions, ComeFromOneLibraryAsAWhole) {
  for (const InstructionSet set : kInstructionSets) {
    const ElementaryFunctions& loaded = load_elementary_functions(set);
    const ElementaryFunctions& scalar = scalar_elementary_functions();
    const bool has_sleef = loaded.Exp.vector != nullptr;
#define UNARY(Name, name)                                       \
  EXPECT_EQ(loaded.Name.vector != nullptr, has_sleef) << #name; \
  EXPECT_EQ(scalar.Name.vector, nullptr) << #name;              \
  EXPECT_NE(scalar.Name.scalar, nullptr) << #name;
#define BINARY(Name, name) UNARY(Name, name)
#include "eval/elementary_functions.def"
#undef UNARY
#undef BINARY
  }
}

TEST(InstructionSet, TheBestOneIsThere) {
  EXPECT_TRUE(has_instruction_set(best_instruction_set()));
  EXPECT_TRUE(has_instruction_set(InstructionSet::Sse2));
}

TEST(Compile, GivesGraphsAndParameters) {
  ir::Program program;
  program.parameters = {
      {.id = {}, .name = {}, .canonical = "k", .type = Type::Real, .value = {0.5, 9, 9}, .equation = {}},
      {.id = {}, .name = {}, .canonical = "c", .type = Type::Colour, .value = {1, 2, 3}, .equation = {}}};
  Graph graph;
  const ValueId k = graph.leaf(Op::Parameter, Type::Real, 0), c = graph.leaf(Op::Parameter, Type::Colour, 1);
  graph.roots = {graph.add(Op::Multiply, {graph.add(Op::Power, {k, graph.constant(2)}), c})};
  program.definitions.push_back({.id = {},
                                 .name = {},
                                 .canonical = "f",
                                 .signature = {.is_function = false, .parameters = {}, .result = Type::Vector},
                                 .formals = {},
                                 .graph = graph,
                                 .equation = {}});
  const Result<CompiledModel> model = compile(program);
  ASSERT_TRUE(model);
  EXPECT_EQ(model->parameters, (std::vector<Triple>{{0.5, 0.5, 0.5}, {1, 2, 3}}));
  const Triple expected = {0.25, 0.5, 0.75};
  EXPECT_EQ(ReferenceEvaluator(model->unoptimised).evaluate({}, model->parameters), expected);
  EXPECT_EQ(ReferenceEvaluator(model->optimised).evaluate({}, model->parameters), expected);
  EXPECT_EQ(evaluate_batch(BatchEvaluator(model->optimised), {Geometry{}}, model->parameters)[0], expected);
}

}  // namespace
}  // namespace texbrdf::eval
