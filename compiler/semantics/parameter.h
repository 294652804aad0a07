#pragma once

#include <array>
#include <optional>

#include "semantics/types.h"
#include "syntax/parsed_block.h"

namespace texbrdf {

/// A definition that a person may turn with a slider: its right side is a number (signed too), or a vector literal or
/// tuple of numbers with components in [0, 1], and its block has no `% constant`. Whether it really is a parameter is
/// decided at link time.
struct ParameterLiteral {
  Type type = Type::Real;         ///< Real, or Colour for three numbers
  std::array<double, 3> value{};  ///< linear RGB for a colour; value[0] for a real
  double minimum = 0;             ///< of every component; minimum <= value <= maximum
  double maximum = 1;
  NodeId literal;  ///< the right side, sign included
};

/// Reads the literal, and the range: `% range [0.01, 1]` in the block, else a documented default that contains the
/// value. A malformed or reversed range comment, or one that leaves the value out, is reported and the default holds.
std::optional<ParameterLiteral> parameter_literal(const ParsedBlock& block, const DefinitionSyntax& definition,
                                                  std::vector<Diagnostic>& diagnostics);

}  // namespace texbrdf
