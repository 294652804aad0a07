#pragma once

#include <vector>

#include "analysis/changed_names.h"
#include "analysis/engine_state.h"
#include "analysis/snapshot.h"
#include "analysis/working_blocks.h"

namespace texbrdf {

/// Checks the definitions without a record, and those that mention a name of which something else is known now, in the
/// order of heights: each at most once. What does not change the fact of its name stops there.
void check_changes(EngineState& state, WorkingBlocks& blocks, const std::vector<NameId>& names, Counters& counters);
/// Checks all definitions of a document of which none has been checked before. `order`: the names with a definition in
/// force, each behind those that it mentions.
void check_all(EngineState& state, WorkingBlocks& blocks, const std::vector<NameId>& order, Counters& counters);

}  // namespace texbrdf
