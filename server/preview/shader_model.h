#pragma once

#include "ir/program.h"
#include "render/shader_model.h"
#include "source/result.h"

namespace texbrdf::preview {

/// The program as the GPU takes it: emitted GLSL whose parameters are uniforms, and their values.
Result<render::ShaderModel> shader_model(const ir::Program& program);

}  // namespace texbrdf::preview
