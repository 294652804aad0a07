#pragma once

#include <vector>

#include "analysis/engine_state.h"
#include "analysis/snapshot.h"
#include "analysis/working_blocks.h"

namespace texbrdf {

/// A block that came, went or has another text. Good as long as the touched and the opened blocks stay.
struct BlockChange {
  BlockLabel label = 0;
  const AnalysedBlock* before = nullptr;  ///< nullptr where there was none
  const AnalysedBlock* after = nullptr;   ///< nullptr where there is none
};

/// Reads the touched blocks and opens them in `blocks`, in document order. What has the same bytes as a block that is
/// gone is taken over from it.
std::vector<BlockChange> read_changed_blocks(const EngineState& state, const TouchedBlocks& touched,
                                             WorkingBlocks& blocks, Counters& counters);

}  // namespace texbrdf
