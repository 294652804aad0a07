#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

#include "files/file_source.h"
#include "render/scene_picture.h"
#include "scene/scene_shader.h"
#include "scene_json/load_scene.h"
#include "source/internal_error.h"

// What a frame of each scene of docs/gallery/scenes costs, 512 pixels wide with one sample.

namespace texbrdf {
namespace {

namespace fs = std::filesystem;

scene::Scene load(const fs::path& path) {
  files::DiskFiles disk;
  auto loaded = scene_json::load_scene(path.string(), disk);
  require(loaded.scene.has_value(), "the example scenes have no error");
  return *std::move(loaded.scene);
}

render::SceneRequest request_of(const scene::Scene& scene) {
  return {make_scene_shader(scene).source,
          {scene.camera, scene.lights, scene.environment, scene.settings, scene_frames(scene)},
          {},
          {512, 512, 0, 0, 512, 512},
          {}};
}

render::RenderWorker make_worker() {
  render::WorkerOptions options;
  options.executable = TEXBRDF_RENDER_WORKER;
  options.arguments.clear();
  return render::RenderWorker(std::move(options));
}

render::SceneAnswer trace(render::RenderWorker& worker, const render::SceneRequest& request) {
  auto answer = worker.trace(request);
  if (const auto* fault = std::get_if<render::RenderFault>(&answer)) {
    std::cerr << fault->message << '\n';
    std::exit(1);
  }
  return std::get<render::SceneAnswer>(std::move(answer));
}

void scene_frame(benchmark::State& state, const fs::path& path) {
  const render::SceneRequest request = request_of(load(path));
  render::RenderWorker worker = make_worker();
  state.counters["first_ms"] = trace(worker, request).milliseconds;
  double least = 1e9;
  for (auto _ : state) least = std::min(least, trace(worker, request).milliseconds);
  state.counters["least_ms"] = least;
}

/// One pixel, so that what is drawn hardly counts: the frames of all objects, and the message.
void scene_moved_object(benchmark::State& state, const fs::path& path) {
  scene::Scene scene = load(path);
  render::SceneRequest request = request_of(scene);
  request.tile = {512, 512, 0, 0, 1, 1};
  render::RenderWorker worker = make_worker();
  trace(worker, request);
  for (auto _ : state) {
    for (scene::Node& node : scene.nodes) {
      if (node.dynamic) node.transform.position[0] += 1e-3;
    }
    request.state.frames = scene_frames(scene);
    require(!trace(worker, request).compiled, "a moved object compiles nothing");
  }
}

void add_benchmarks() {
  const fs::path folder = fs::path(TEXBRDF_SOURCE_DIR) / "docs/gallery/scenes";
  std::vector<fs::path> scenes;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().string().ends_with(".scene.json")) scenes.push_back(entry.path());
  }
  std::ranges::sort(scenes);
  for (const fs::path& path : scenes) {
    const std::string name = "scene_frame/" + path.stem().stem().string();
    benchmark::RegisterBenchmark(name.c_str(), scene_frame, path)->Unit(benchmark::kMillisecond)->UseRealTime();
  }
  benchmark::RegisterBenchmark("scene_moved_object", scene_moved_object, folder / "steered.scene.json")
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

}  // namespace
}  // namespace texbrdf

int main(int argc, char** argv) {
  texbrdf::add_benchmarks();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
