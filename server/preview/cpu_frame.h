#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "eval/batch.h"
#include "ir/program.h"
#include "render/tone_map.h"
#include "source/result.h"

namespace texbrdf::preview {

/// A program ready for the batch evaluator.
struct CpuModel {
  eval::BatchEvaluator evaluator;
  std::vector<eval::Triple> parameters;
  bool depends_on_directions = true;
};

Result<CpuModel> cpu_model(const ir::Program& program);

/// Takes the values of `count` points from `first` on; false: no more are wanted.
using ShadedVisitor = std::function<bool(std::size_t first, std::size_t count, const render::ShadedValues& values)>;

/// The values at all points of a geometry, some at a time, in order.
void shade(const CpuModel& model, const render::SphereGeometry& geometry, const ShadedVisitor& visit);

/// Draws the sphere of `view` on this thread. `cache` is kept by the caller from one frame to the next.
render::Picture draw_on_cpu(const CpuModel& model, const render::SphereView& view, render::SphereCache& cache);
/// Nothing where `is_wanted`, which is asked now and then, has said no.
std::optional<render::Picture> draw_on_cpu(const CpuModel& model, const render::SphereView& view,
                                           render::SphereCache& cache, const std::function<bool()>& is_wanted);

}  // namespace texbrdf::preview
