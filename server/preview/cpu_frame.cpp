#include "preview/cpu_frame.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "ir/passes/passes.h"

namespace texbrdf::preview {

namespace {

/// Points that are evaluated at once: their vectors and values stay in the cache.
constexpr std::size_t kStep = 2048;

using Step = std::array<float, kStep>;

std::array<Step, 3> spread(const std::array<float, 3>& direction) {
  std::array<Step, 3> vectors;
  for (std::size_t c = 0; c < 3; ++c) vectors[c].fill(direction[c]);
  return vectors;
}

std::array<const float*, 3> pointers(const std::array<Step, 3>& vectors) {
  return {vectors[0].data(), vectors[1].data(), vectors[2].data()};
}

std::array<const float*, 3> pointers(const render::SphereGeometry::Vectors& vectors, std::size_t begin) {
  return {&vectors[0][begin], &vectors[1][begin], &vectors[2][begin]};
}

}  // namespace

Result<CpuModel> cpu_model(const ir::Program& program) {
  Result<ir::Graph> graph = ir::flatten(program);
  if (!graph) return Failure{graph.error()};
  const ir::Graph optimised = ir::run_passes(*std::move(graph), ir::evaluation_passes());
  const bool depends_on_directions =
      std::ranges::any_of(optimised.values(), [](const ir::Value& v) { return v.op == ir::Op::Convention; });
  CpuModel model{eval::BatchEvaluator(optimised), {}, depends_on_directions};
  for (const ir::Parameter& parameter : program.parameters) model.parameters.push_back(parameter.value);
  return model;
}

void shade(const CpuModel& model, const render::SphereGeometry& geometry, const ShadedVisitor& visit) {
  const std::array<Step, 3> light = spread(geometry.light);
  const std::array<Step, 3> viewer = spread(geometry.view);
  std::array<Step, 3> values;
  const render::ShadedValues shaded{pointers(values), 1};
  const std::size_t total = geometry.point_count();
  for (std::size_t begin = 0; begin < total; begin += kStep) {
    const eval::GeometryBatch batch{
        .count = std::min(kStep, total - begin),
        .light = pointers(light),
        .view = pointers(viewer),
        .normal = pointers(geometry.normals, begin),
        .tangent = pointers(geometry.tangents, begin),
        .bitangent = pointers(geometry.bitangents, begin),
    };
    model.evaluator.evaluate(batch, model.parameters, {values[0].data(), values[1].data(), values[2].data()});
    if (!visit(begin, batch.count, shaded)) return;
  }
}

render::Picture draw_on_cpu(const CpuModel& model, const render::SphereView& view, render::SphereCache& cache) {
  return *draw_on_cpu(model, view, cache, [] { return true; });
}

std::optional<render::Picture> draw_on_cpu(const CpuModel& model, const render::SphereView& view,
                                           render::SphereCache& cache, const std::function<bool()>& is_wanted) {
  const render::SphereGeometry& geometry = cache.geometry(view);
  render::ToneMapper tones(geometry, view);
  bool is_whole = true;
  shade(model, geometry, [&](std::size_t first, std::size_t count, const render::ShadedValues& values) {
    tones.add(first, count, values);
    is_whole = is_wanted();
    return is_whole;
  });
  return is_whole ? std::optional(tones.take()) : std::nullopt;
}

}  // namespace texbrdf::preview
