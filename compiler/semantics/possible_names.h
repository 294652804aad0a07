#pragma once

#include "semantics/known_names.h"

namespace texbrdf {

/// Finds what nodes may be called besides what they are read as, and tells `\hat{\mathbf h}` from `\mathbf h` where the
/// block itself does: where it defines both, or one by the other.
void read_possible_names(const ParsedBlock& block, NameTable& table, BlockNames& names);

/// Reading::names: those of the block that the document defines.
std::vector<uint32_t> find_own_names(const ParsedBlock& block, const BlockNames& names, const KnownNames& known);

}  // namespace texbrdf
