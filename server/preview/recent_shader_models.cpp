#include "preview/recent_shader_models.h"

#include <algorithm>
#include <utility>

#include "preview/shader_model.h"

namespace texbrdf::preview {

Result<const render::ShaderModel*> RecentShaderModels::of(const std::shared_ptr<const ir::Program>& program) {
  const auto known = std::ranges::find(entries_, program, &Entry::program);
  if (known != entries_.end()) {
    std::rotate(known, known + 1, entries_.end());
  } else {
    Result<render::ShaderModel> emitted = shader_model(*program);
    if (!emitted) return Failure{emitted.error()};
    if (entries_.size() == kMost) entries_.erase(entries_.begin());
    entries_.push_back({program, std::make_unique<const render::ShaderModel>(*std::move(emitted))});
  }
  return entries_.back().model.get();
}

}  // namespace texbrdf::preview
