#pragma once

#include "analysis/changed_names.h"
#include "analysis/working_blocks.h"

namespace texbrdf {

/// Reads those blocks again in which a bracket behind a name opens a factor now and opened arguments before, or the
/// other way round: the blocks that are open, and those that mention a name that became a function or ceased to be one.
/// Which names a block holds does not change by that.
void settle_factors(EngineState& state, WorkingBlocks& blocks, const ChangedNames& names, Counters& counters);

}  // namespace texbrdf
