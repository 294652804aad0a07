// Frame times of the evaluators, over the sphere that previews show.

#include <benchmark/benchmark.h>

#include "model.h"

namespace texbrdf::test {
namespace {

constexpr std::size_t kSize = 256;

/// A picture of a sphere: normals of an orthographic view, one light.
std::vector<eval::Geometry> sphere() {
  std::vector<eval::Geometry> result;
  for (std::size_t row = 0; row < kSize; ++row) {
    for (std::size_t column = 0; column < kSize; ++column) {
      const double x = (2 * (static_cast<double>(column) + 0.5) / kSize - 1) / 0.9;
      const double y = (2 * (static_cast<double>(row) + 0.5) / kSize - 1) / 0.9;
      const double radius = std::min(0.99, std::sqrt(x * x + y * y));
      const double z = std::sqrt(1 - radius * radius);
      const double length = std::sqrt(x * x + y * y) / radius;
      result.push_back({.light = {0.48, 0.36, 0.8}, .view = {0, 0, 1}, .normal = {x / length, y / length, z}});
    }
  }
  return result;
}

void shade(benchmark::State& state, const std::string& name, eval::InstructionSet set) {
  const auto model = compile_text(read_text(model_path(name, ".tex")));
  const std::vector<eval::Geometry> geometries = sphere();
  const eval::GeometryArrays arrays(geometries);
  const eval::BatchEvaluator evaluator(model->optimised, set);
  std::vector<float> red(geometries.size()), green(geometries.size()), blue(geometries.size());
  for (auto _ : state) {
    evaluator.evaluate(arrays.batch(), model->parameters, {red.data(), green.data(), blue.data()});
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * geometries.size()));
}

void build(benchmark::State& state) {
  const auto model = compile_text(read_text(model_path("cook-torrance", ".tex")));
  for (auto _ : state) benchmark::DoNotOptimize(eval::BatchEvaluator(model->optimised));
}

void reference(benchmark::State& state) {
  const auto model = compile_text(read_text(model_path("cook-torrance", ".tex")));
  const eval::ReferenceEvaluator evaluator(model->unoptimised);
  for (auto _ : state) {
    benchmark::DoNotOptimize(evaluator.evaluate({.light = {0.48, 0.36, 0.8}, .view = {0, 0, 1}}, model->parameters));
  }
}

void register_all() {
  for (const std::string& name : model_names()) {
    for (const eval::InstructionSet set : eval::kInstructionSets) {
      if (!eval::has_instruction_set(set)) continue;
      const std::string title = "shade_256/" + name + "/" + std::string(eval::instruction_set_name(set));
      benchmark::RegisterBenchmark(title.c_str(), [name, set](benchmark::State& state) {
        shade(state, name, set);
      })->Unit(benchmark::kMillisecond);
    }
  }
  benchmark::RegisterBenchmark("build_tape/cook-torrance", build)->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("reference/cook-torrance", reference)->Unit(benchmark::kMicrosecond);
}

}  // namespace
}  // namespace texbrdf::test

int main(int argc, char** argv) {
  texbrdf::test::register_all();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
