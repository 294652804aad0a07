#include <benchmark/benchmark.h>

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

#include "analysis/document.h"
#include "preview/cpu_frame.h"
#include "preview/shader_model.h"
#include "render/png.h"
#include "render/worker_client.h"

// What a picture costs, 256 pixels wide: cook-torrance unless said otherwise.

namespace texbrdf {
namespace {

ir::Program cook_torrance() {
  std::ostringstream text;
  text << std::ifstream(TEXBRDF_TEST_DATA "/models/cook-torrance.tex").rdbuf();
  Document document(text.str());
  auto program = document.snapshot().program("f");
  require(static_cast<bool>(program), "cook-torrance.tex has a program");
  return *std::move(program);
}

render::WorkerOptions options() {
  render::WorkerOptions options;
  options.executable = TEXBRDF_RENDER_WORKER;
  options.arguments.clear();
  return options;
}

render::GpuPicture draw(render::RenderWorker& worker, const render::ShaderModel& model) {
  auto result = worker.draw(model, {});
  if (const auto* fault = std::get_if<render::RenderFault>(&result)) {
    std::cerr << fault->message << '\n';
    std::exit(1);
  }
  return std::get<render::GpuPicture>(std::move(result));
}

void cpu_prepare(benchmark::State& state) {
  const ir::Program program = cook_torrance();
  for (auto _ : state) benchmark::DoNotOptimize(preview::cpu_model(program));
}
BENCHMARK(cpu_prepare)->Unit(benchmark::kMillisecond);

void cpu_frame(benchmark::State& state) {
  const auto model = preview::cpu_model(cook_torrance());
  render::SphereCache cache;
  for (auto _ : state) benchmark::DoNotOptimize(preview::draw_on_cpu(*model, {}, cache));
}
BENCHMARK(cpu_frame)->Unit(benchmark::kMillisecond);

void tone_mapping(benchmark::State& state) {
  const render::SphereGeometry sphere = render::make_sphere_geometry({});
  const std::vector<float> values(sphere.point_count(), 0.25F);
  for (auto _ : state) {
    benchmark::DoNotOptimize(tone_map(sphere, {}, {{values.data(), values.data(), values.data()}, 1}));
  }
}
BENCHMARK(tone_mapping)->Unit(benchmark::kMillisecond);

void sphere_geometry(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(render::make_sphere_geometry({}));
}
BENCHMARK(sphere_geometry)->Unit(benchmark::kMillisecond);

void png(benchmark::State& state) {
  const auto model = preview::cpu_model(cook_torrance());
  render::SphereCache cache;
  const render::Picture picture = preview::draw_on_cpu(*model, {}, cache);
  const auto effort = static_cast<render::PngEffort>(state.range(0));
  std::size_t bytes = 0;
  for (auto _ : state) bytes = encode_png(picture.image, effort).size();
  state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(png)->ArgName("effort")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

/// A fresh worker each time: process, EGL, glslang's tables, the first compilation.
void gpu_first_frame(benchmark::State& state) {
  const auto model = preview::shader_model(cook_torrance());
  for (auto _ : state) {
    render::RenderWorker worker(options());
    draw(worker, *model);
  }
}
BENCHMARK(gpu_first_frame)->Unit(benchmark::kMillisecond)->UseRealTime();

void gpu_uniform_change(benchmark::State& state) {
  auto model = preview::shader_model(cook_torrance());
  render::RenderWorker worker(options());
  draw(worker, *model);
  for (auto _ : state) {
    model->uniforms[0].value[0] += 1e-4F;
    require(!draw(worker, *model).compiled, "a uniform change compiles nothing");
  }
}
BENCHMARK(gpu_uniform_change)->Unit(benchmark::kMillisecond)->UseRealTime();

/// Every round a source that neither the worker nor Mesa's cache on disk has seen.
void gpu_recompile(benchmark::State& state) {
  const auto model = preview::shader_model(cook_torrance());
  render::RenderWorker worker(options());
  draw(worker, *model);
  const auto stamp = std::chrono::steady_clock::now().time_since_epoch().count() % 1'000'000;
  uint32_t round = 0;
  for (auto _ : state) {
    render::ShaderModel changed = *model;
    const std::size_t body = changed.source.rfind("return ") + 7;
    changed.source.insert(body, fmt::format("{}.{:07}e-9 + ", ++round, stamp));
    require(draw(worker, changed).compiled, "another source is compiled");
  }
}
BENCHMARK(gpu_recompile)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace texbrdf

BENCHMARK_MAIN();
