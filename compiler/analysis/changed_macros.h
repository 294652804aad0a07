#pragma once

#include "analysis/engine_state.h"

namespace texbrdf {

/// Brings the macros of the document up to date, and has the blocks read again that use one which stands for another
/// text now: they are touched. Goes over all blocks only where some macro changed.
void update_macros(EngineState& state, TouchedBlocks& touched);

}  // namespace texbrdf
