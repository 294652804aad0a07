#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "analysis/snapshot_state.h"

namespace texbrdf {

/// What stands for a parameter: a name of the convention, or a definition of the document.
using RootArgument = std::variant<Convention, NameId>;

/// Papers write a BRDF as a function of angles, of a position, of its constants: `f_r(\theta_i, \phi_i; \theta_o,
/// \phi_o; \sigma)`. Each parameter is given what its name means outside of the function; nothing where one has no
/// meaning, or of another type, and where the function has two vectors, which are the directions whatever they are
/// called.
std::optional<std::vector<RootArgument>> root_arguments(const Snapshot::State& state, const CheckedDefinition& root);

/// A plain definition: `root` of its arguments.
ir::LinkableDefinition call_of_root(const Snapshot::State& state, const LocatedDefinition& root,
                                    const std::vector<RootArgument>& arguments);

}  // namespace texbrdf
