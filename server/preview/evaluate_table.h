#pragma once

#include <functional>
#include <variant>
#include <vector>

#include "preview/cpu_frame.h"
#include "render/geometry_table.h"
#include "render/worker_client.h"

namespace texbrdf::preview {

/// Red, green and blue of f at each geometry, or why there are none.
using EvaluatedTable = std::variant<std::vector<float>, render::RenderFault>;
/// A device with a model: CPU and GPU are given the same geometries.
using TableEvaluator = std::function<EvaluatedTable(const render::GeometryTable&)>;

std::vector<float> evaluate_table(const CpuModel& model, const render::GeometryTable& geometries);

/// All arguments outlive the evaluator.
TableEvaluator evaluator_on_cpu(const CpuModel& model);
TableEvaluator evaluator_on_gpu(render::RenderWorker& worker, const render::ShaderModel& model);

}  // namespace texbrdf::preview
