#pragma once

#include <optional>

#include "analysis/snapshot_state.h"

namespace texbrdf {

/// Problems that a vector may have in the place of a colour, or a tuple in that of a vector.
bool may_want_tuple(Code code);

/// Where a vector stands in the place of a colour and is made of literals `\vec{…}` only, written there or in the
/// definitions that are named: the fix that turns them into tuples, `(a, b, c)`. For a product that may be meant as a
/// dot product, the fix that turns a tuple of numbers into a literal. `problem` is one of `inside`.
std::optional<Fix> tuple_fix(const Snapshot::State& state, const LocatedDefinition& inside, const Diagnostic& problem);

}  // namespace texbrdf
