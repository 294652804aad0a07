#pragma once

#include <compare>
#include <string>
#include <vector>

#include "ir/program.h"

namespace texbrdf::emit {

/// What a function reads although it is none of its own parameters.
struct Capture {
  enum class Kind : uint8_t { Input, Parameter, Definition, Derived };
  Kind kind = Kind::Input;
  uint32_t index = 0;  ///< Convention (of an input, or of one derived from inputs), or index into the program
  friend auto operator<=>(const Capture&, const Capture&) = default;
};

/// A function of the document without free names: what it captured is passed to it.
struct LiftedFunction {
  uint32_t definition = 0;        ///< index in Program::definitions
  std::vector<Capture> captures;  ///< further parameters, behind its own
  ir::Graph graph;                ///< roots[0] is its value; calls have their captures as further operands
};

/// The program as functions that see nothing but their parameters, and one body: the entry point's.
struct LiftedProgram {
  std::vector<LiftedFunction> functions;  ///< callees before callers
  /// Plain definitions in order of need, the root last; definitions[i] has body.roots[i] as its value.
  std::vector<uint32_t> definitions;
  ir::Graph body;
  std::vector<bool> parameter_used;  ///< by index of Program::parameters
};

/// Whether parameters are visible everywhere (uniforms), or handed on like everything else.
enum class ParameterScope : uint8_t { Everywhere, EntryPoint };

/// Lambda lifting. Drops what the root does not need, and definitions that are only another word for an input whose
/// symbol they bear (`N = \vec{n}`). Fails where the code would become absurdly long.
Result<LiftedProgram> lift(const ir::Program& program, ParameterScope scope);

/// The program as `lift` wants it: a root of two vectors has the light and the view in place of its parameters.
ir::Program with_directions_for_root_formals(ir::Program program);

}  // namespace texbrdf::emit
