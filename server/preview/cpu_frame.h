#pragma once

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

/// Draws the sphere of `view` on this thread. `cache` is kept by the caller from one frame to the next.
render::Picture draw_on_cpu(const CpuModel& model, const render::SphereView& view, render::SphereCache& cache);

}  // namespace texbrdf::preview
