#pragma once

#include <optional>
#include <span>

#include "ir/program.h"

namespace texbrdf::ir {

/// Derivatives become what they are by the rules of calculus, exactly, in forward mode. What they call is written out
/// in them; so are definitions that depend on the variable where that is a name of the document. The graph is linked
/// with `definitions`, which hold neither derivatives nor integrals. Nothing where the result would be too large.
std::optional<Graph> expand_derivatives(const Graph& graph, std::span<const ProgramDefinition> definitions);

}  // namespace texbrdf::ir
