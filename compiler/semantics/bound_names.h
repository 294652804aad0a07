#pragma once

#include "semantics/names.h"

namespace texbrdf {

/// Fills in which names are bound, and which stand for others: by the block's bytes alone, so that the names that a
/// definition may ask of the document are known before anything is checked.
void read_bound_names(const ParsedBlock& block, NameTable& table, BlockNames& names);

}  // namespace texbrdf
