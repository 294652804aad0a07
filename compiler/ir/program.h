#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ir/graph.h"
#include "ir/quadrature.h"
#include "semantics/check.h"
#include "semantics/names.h"
#include "semantics/parameter.h"
#include "source/result.h"

namespace texbrdf::ir {

/// A definition as the linker takes it.
struct LinkableDefinition {
  NameId id;
  Name name;              ///< for the namer of generated code
  std::string canonical;  ///< canonical_form(name)
  Signature signature;
  std::vector<Name> formals;  ///< names of the parameters, in order
  Graph graph;                ///< from lower_definition
  std::optional<ParameterLiteral> literal;
  std::string equation;  ///< the source of the equation on one line, white space folded
};

/// Where the linker finds definitions; nullptr for one that is not sound.
using DefinitionLookup = std::function<const LinkableDefinition*(const Instance&)>;

/// A number or colour that can be changed without compiling again.
struct Parameter {
  NameId id;
  Name name;
  std::string canonical;
  Type type = Type::Real;         ///< Real or Colour
  std::array<double, 3> value{};  ///< value[0] for Real
  double minimum = 0;
  double maximum = 1;
  std::string equation;
};

/// A definition of an aggregate type becomes one for each entry.
struct ProgramDefinition {
  NameId id;  ///< several have it where a function is called with several types
  Name name;
  std::string canonical;
  Signature signature;
  std::vector<Name> formals;
  /// References and calls are indices of Program::definitions, all smaller than this one's own. Definitions that became
  /// parameters are Op::Parameter.
  Graph graph;
  std::string equation;
};

/// All that a root needs, and nothing else: what emitters and the evaluator read.
struct Program {
  std::vector<Parameter> parameters;           ///< in document order of first need
  std::vector<ProgramDefinition> definitions;  ///< in order of need; the root is the last
  const ProgramDefinition& root() const { return definitions.back(); }
};

struct LinkOptions {
  /// Values from outside, by canonical name; a real gives one number, a colour three. Unknown names, names that are no
  /// parameter and wrong counts are failures that name the parameters there are.
  std::map<std::string, std::vector<double>> values = {};
  Fineness fineness = Fineness::Full;  ///< of integrals
};

/// Joins what `root` needs. Fails with a reason for a person (a definition in error, a bad --set). Iterative.
Result<Program> link(const DefinitionLookup& lookup, NameId root, const LinkOptions& options);

/// The most values a flattened graph may have: calls within calls can double at each level.
inline constexpr uint32_t kMaxFlatValues = 1'000'000;

/// One graph without references, calls and formals, for evaluation: functions are inlined per instance, each plain
/// definition appears once. Formals of a root function of two vectors become the conventions OmegaI and OmegaO.
/// roots[0] is the root; with `all_plain`, then the value of each plain definition in the order of
/// Program::definitions. Fails where it would exceed kMaxFlatValues.
Result<Graph> flatten(const Program& program, bool all_plain = false);

}  // namespace texbrdf::ir
