#pragma once

#include "analysis/engine_state.h"
#include "analysis/snapshot.h"

namespace texbrdf {

/// What an update found out, beside the state.
struct UpdateResult {
  Counters counters;
  OccurrencesByName occurrences;
  bool other_definitions = false;  ///< some name has got or lost a definition
};

/// Reads the touched blocks and checks every definition that they can affect: those in them, and those that mention a
/// name of which others now see something else. `state.text` and `state.segments` are those after the edits already;
/// all else is brought up to date. `before` is what the update before gave.
UpdateResult update(EngineState& state, const TouchedBlocks& touched, const OccurrencesByName& before);

}  // namespace texbrdf
