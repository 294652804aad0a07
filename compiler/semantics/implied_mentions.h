#pragma once

#include <string_view>
#include <vector>

#include "semantics/known_names.h"

namespace texbrdf {

/// Names that a definition depends on although it does not mention them: arguments of a function that stands without
/// (`DFG`), the vector of a component (`h_x`) and of an angle (`\theta_m`). Each once, in order of NameId.
std::vector<NameId> implied_mentions(const ParsedBlock& block, const DefinitionSyntax& definition,
                                     const BlockNames& names, NameTable& table, const KnownNames& known);

/// What the vector may be called whose angle is called after the label: `m`, `\vec{m}`, `\omega_m` …
std::vector<std::string> directions_called(std::string_view label);

}  // namespace texbrdf
