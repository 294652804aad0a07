#pragma once

#include "emit/emit.h"

namespace texbrdf::emit {

/// Functions without a #version line; `vec3 brdf(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y)` is the last.
Result<EmittedCode> emit_glsl(const ir::Program& program, const EmitOptions& options);

}  // namespace texbrdf::emit
