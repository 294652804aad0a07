#pragma once

#include "emit/emit.h"

namespace texbrdf::emit {

/// A .brdf file: parameters with their ranges, then the shader.
Result<EmittedCode> emit_disney(const ir::Program& program, const EmitOptions& options);

}  // namespace texbrdf::emit
