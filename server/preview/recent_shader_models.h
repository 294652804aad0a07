#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "ir/program.h"
#include "render/shader_model.h"
#include "source/result.h"

namespace texbrdf::preview {

/// What was emitted of the programs that were asked for last: previews beside each other take turns.
class RecentShaderModels {
 public:
  static constexpr std::size_t kMost = 4;

  /// The model lives until so many others were asked for.
  Result<const render::ShaderModel*> of(const std::shared_ptr<const ir::Program>& program);

 private:
  struct Entry {
    std::shared_ptr<const ir::Program> program;
    std::unique_ptr<const render::ShaderModel> model;
  };
  std::vector<Entry> entries_;  // in the order of their last use
};

}  // namespace texbrdf::preview
