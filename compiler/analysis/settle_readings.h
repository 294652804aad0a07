#pragma once

#include "analysis/changed_names.h"
#include "analysis/working_blocks.h"

namespace texbrdf {

/// Reads blocks once more where what the document makes of names asks for another reading than they have: brackets that
/// open factors, words that are products, functions without their arguments. `names` is what changed so far; what the
/// new readings change is added to it.
void settle_readings(EngineState& state, WorkingBlocks& blocks, ChangedNames& names, Counters& counters);

}  // namespace texbrdf
