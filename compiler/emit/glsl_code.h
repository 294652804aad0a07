#pragma once

#include <string>
#include <vector>

#include "emit/code_text.h"
#include "emit/dialect.h"
#include "emit/lift.h"
#include "emit/namer.h"
#include "ir/program.h"
#include "source/result.h"

namespace texbrdf::emit {

/// A program as functions of GLSL, the entry point last.
struct GlslCode {
  std::vector<std::string> parameters;  ///< identifiers, by index of Program::parameters
  CodeText functions;
};

/// `scope`: Everywhere for parameters that are uniforms.
Result<GlslCode> write_glsl(const ir::Program& program, const Dialect& dialect, ParameterScope scope);

/// The identifiers of the parameters, in order: they come before all other names.
std::vector<std::string> claim_parameters(const ir::Program& program, Namer& names);
/// A namer that knows the inputs of the entry point.
Namer entry_point_names(const Dialect& dialect);

}  // namespace texbrdf::emit
