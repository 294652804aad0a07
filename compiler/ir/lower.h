#pragma once

#include "ir/graph.h"
#include "semantics/check.h"

namespace texbrdf::ir {

/// The graph of one definition, exactly as written (nothing folded). References and calls carry NameId::value, formals
/// their position. Conventions are built from their operands, so that a parameter that shadows one carries its derived
/// conventions along: in g(\omega_i) = \cos\theta_i the operand of theta_i is the formal.
/// Precondition: checked.sound.
Graph lower_definition(const ParsedBlock& block, const DefinitionSyntax& definition, const BlockNames& names,
                       const CheckedDefinition& checked);

}  // namespace texbrdf::ir
