#include "preview/evaluate_table.h"

#include <array>

namespace texbrdf::preview {

std::vector<float> evaluate_table(const CpuModel& model, const render::GeometryTable& geometries) {
  const std::size_t count = geometries[0].size();
  const auto vector = [&](std::size_t first) {
    return std::array<const float*, 3>{geometries[first].data(), geometries[first + 1].data(),
                                       geometries[first + 2].data()};
  };
  const eval::GeometryBatch batch{.count = count,
                                  .light = vector(0),
                                  .view = vector(3),
                                  .normal = vector(6),
                                  .tangent = vector(9),
                                  .bitangent = vector(12)};
  std::array<std::vector<float>, 3> channels;
  for (std::vector<float>& channel : channels) channel.resize(count);
  model.evaluator.evaluate(batch, model.parameters, {channels[0].data(), channels[1].data(), channels[2].data()});
  std::vector<float> values(count * 3);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t c = 0; c < 3; ++c) values[i * 3 + c] = channels[c][i];
  }
  return values;
}

TableEvaluator evaluator_on_cpu(const CpuModel& model) {
  return [&model](const render::GeometryTable& geometries) { return evaluate_table(model, geometries); };
}

TableEvaluator evaluator_on_gpu(render::RenderWorker& worker, const render::ShaderModel& model) {
  return
      [&worker, &model](const render::GeometryTable& geometries) { return worker.evaluate_table(model, geometries); };
}

}  // namespace texbrdf::preview
