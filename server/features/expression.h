#pragma once

#include <cstdint>
#include <optional>

#include "analysis/snapshot.h"

namespace texbrdf::features {

/// The right side of a definition, or a part of it.
struct Expression {
  DefinitionId definition;
  NodeId node;
};

/// The part of a right side whose operator, command or bracket stands at the offset; nothing for names, numbers and
/// what cannot be read.
std::optional<Expression> expression_at(const Snapshot& snapshot, uint32_t offset);

/// Error where it is not known.
Type type_of(const Snapshot& snapshot, const Expression& expression);

/// The expression as a program of its own. Nothing where it has no value without arguments, where it or something that
/// it needs is in error, and where it needs more than `most_values` values, all calls written out.
std::optional<ir::Program> program_of(const Snapshot& snapshot, const Expression& expression, uint32_t most_values);

}  // namespace texbrdf::features
