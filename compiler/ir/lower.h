#pragma once

#include "ir/graph.h"
#include "semantics/check.h"

namespace texbrdf::ir {

/// What an expression is that a left side has as a parameter, as in `F(a - b) = …`.
enum class Expressions : uint8_t {
  AreArguments,   ///< what the caller gives
  AreWrittenOut,  ///< itself, made of what its names mean in the document
};

/// The op of \cos and the like.
Op function_op(Command function);

/// The graph of one definition, exactly as written (nothing folded). References and calls carry NameId::value, or the
/// place of an instance, formals their position, where each entry of an aggregate is a formal and an argument of its
/// own. Conventions are built from their operands, so that a parameter that shadows one carries its derived conventions
/// along: in g(\omega_i) =
/// \cos\theta_i the operand of theta_i is the formal. Precondition: checked.sound.
Graph lower_definition(const ParsedBlock& block, const DefinitionSyntax& definition, const BlockNames& names,
                       const CheckedDefinition& checked, Expressions expressions = Expressions::AreArguments);

}  // namespace texbrdf::ir
