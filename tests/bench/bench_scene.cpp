#include <benchmark/benchmark.h>

#include "scene/distance.h"
#include "scene/scene_shader.h"
#include "support/random_scene.h"

namespace texbrdf {
namespace {

/// As many objects as the argument says, some of them dynamic.
scene::Scene many_objects(std::size_t count) {
  scene::Scene scene;
  for (uint64_t seed = 1; scene.nodes.size() < count; ++seed) {
    const scene::Scene more = test::RandomScene(seed).make();
    const auto first = static_cast<uint32_t>(scene.nodes.size());
    for (scene::Node node : more.nodes) {
      for (scene::NodeId& child : node.children) child.value += first;
      scene.nodes.push_back(std::move(node));
    }
    for (const scene::NodeId root : more.roots) scene.roots.push_back({root.value + first});
  }
  for (std::size_t i = 0; i < scene::kMaxDynamic; ++i)
    scene.nodes[scene.roots[i % scene.roots.size()].value].dynamic = scene::Dynamic{"d" + std::to_string(i), {}};
  return scene;
}

void make_shader(benchmark::State& state) {
  const scene::Scene scene = many_objects(static_cast<std::size_t>(state.range(0)));
  std::size_t bytes = 0;
  for (auto _ : state) bytes = make_scene_shader(scene).source.size();
  state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(make_shader)->Arg(10)->Arg(100)->Arg(1000)->Arg(4000)->Unit(benchmark::kMillisecond);

/// What moving an object costs before it is sent.
void frames_of_dynamic_objects(benchmark::State& state) {
  const scene::Scene scene = many_objects(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(scene_frames(scene));
}
BENCHMARK(frames_of_dynamic_objects)->Arg(100)->Arg(4000)->Unit(benchmark::kMicrosecond);

void distance(benchmark::State& state) {
  const scene::Scene scene = many_objects(static_cast<std::size_t>(state.range(0)));
  const scene::Distances distances(scene, {.guards = state.range(1) != 0});
  test::Random random(1);
  for (auto _ : state) {
    benchmark::DoNotOptimize(distances.at({random.real(-3, 3), random.real(-3, 3), random.real(-3, 3)}));
  }
}
BENCHMARK(distance)->ArgNames({"objects", "guards"})->Args({100, 0})->Args({100, 1})->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace texbrdf
