#include "preview/bad_values.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "eval/compile.h"
#include "preview/cpu_frame.h"
#include "preview/step_count.h"
#include "preview/surface_probe.h"

namespace texbrdf::preview {
namespace {

constexpr uint32_t kMaxSize = 256;
constexpr uint32_t kMinSize = 16;
/// Of the batch evaluator, over all points together: some 10 ms.
constexpr double kMaxBatchSteps = 5e7;
/// Of the reference evaluator.
constexpr uint64_t kMaxSteps = 500'000;

/// The largest picture that can be afforded; 0 where none can.
uint32_t affordable_size(uint32_t wanted, double steps) {
  uint32_t size = std::min(wanted, kMaxSize);
  while (size >= kMinSize && steps * size * size > kMaxBatchSteps) size /= 2;
  return size >= kMinSize ? size : 0;
}

/// Searches a picture with the batch evaluator. The pixels that it finds bad.
std::vector<uint32_t> find_candidates(const CpuModel& model, const render::SphereView& view,
                                      render::BadPixelCounts& counts) {
  const render::SphereGeometry geometry = render::make_sphere_geometry(view);
  std::vector<uint32_t> candidates;
  shade(model, geometry, [&](std::size_t first, std::size_t count, const render::ShadedValues& values) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::array value{values.channels[0][i], values.channels[1][i], values.channels[2][i]};
      const std::optional<render::BadPixel> kind = render::find_bad(value);
      if (!kind) continue;
      ++counts[*kind];
      candidates.push_back(geometry.pixels[first + i]);
    }
    return true;
  });
  return candidates;
}

class Confirmation {
 public:
  Confirmation(const ExactModel& model, const render::SphereView& view) : model_(model), view_(view) {}

  std::optional<BadValue> first_of(std::span<const uint32_t> candidates) {
    for (const uint32_t pixel : candidates) {
      const render::PicturePlace place = render::sample_place(view_, pixel);
      const std::optional<SurfaceProbe> probe = probe_surface(view_, place);
      if (!probe) continue;
      const std::optional<eval::Triple> value = model_.value(probe->geometry, budget_);
      if (!value) return std::nullopt;
      const std::optional<render::BadPixel> kind = render::find_bad(*value);
      if (kind) return BadValue{place, *kind, origin(probe->geometry, *kind)};
    }
    return std::nullopt;
  }

 private:
  std::string origin(const eval::Geometry& geometry, render::BadPixel kind) {
    eval::StepBudget budget{kMaxSteps};
    const auto values = model_.values(geometry, budget);
    return values ? origin_of(model_, *values, kind).name : model_.brdf().name;
  }

  const ExactModel& model_;
  const render::SphereView& view_;
  eval::StepBudget budget_{kMaxSteps};
};

}  // namespace

BadValues find_bad_values(const ExactModel& model, const render::SphereView& view) {
  const Result<eval::CompiledModel> compiled = eval::compile(model.program());
  if (!compiled) return no_bad_values(compiled.error());
  BadValues found;
  found.size = affordable_size(view.size, most_steps(compiled->optimised, compiled->parameters));
  if (found.size == 0) return no_bad_values("the BRDF is too slow for a search of its bad pixels");
  render::SphereView searched = view;
  searched.size = found.size;
  const CpuModel batch{eval::BatchEvaluator(compiled->optimised), compiled->parameters};
  const std::vector<uint32_t> candidates = find_candidates(batch, searched, found.counts);
  found.first = Confirmation(model, searched).first_of(candidates);
  return found;
}

BadValues no_bad_values(std::string problem) {
  BadValues nothing;
  nothing.problem = std::move(problem);
  return nothing;
}

}  // namespace texbrdf::preview
