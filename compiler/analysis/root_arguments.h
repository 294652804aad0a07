#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "analysis/snapshot_state.h"

namespace texbrdf {

/// What stands for a parameter: a name of the convention, a definition of the document, or anything, as no value
/// depends on it.
using RootArgument = std::variant<Convention, NameId, std::monostate>;

/// Of a BRDF of two directions, or of three parameters or more of which it reads some, one on which it does not depend,
/// as the place or the wavelength, may be anything.
bool may_be_anything(const Signature& signature, uint32_t position);

/// Papers write a BRDF as a function of angles, of a position, of its constants: `f_r(\theta_i, \phi_i; \theta_o,
/// \phi_o; \sigma)`. Each parameter is given what its name means outside of the function; nothing where one has no
/// meaning, or of another type, and where the function has two vectors, which are the directions whatever they are
/// called.
/// An expression that is a parameter stays what it is: the function that is called has it written out.
std::optional<std::vector<RootArgument>> root_arguments(const Snapshot::State& state, const LocatedDefinition& root);

/// A plain definition: `function`, which says what `root` does, of the arguments.
ir::LinkableDefinition call_of_root(const Snapshot::State& state, const LocatedDefinition& root, NameId function,
                                    const std::vector<RootArgument>& arguments);

}  // namespace texbrdf
