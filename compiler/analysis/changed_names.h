#pragma once

#include <vector>

#include "analysis/changed_blocks.h"
#include "analysis/engine_state.h"

namespace texbrdf {

/// What changed blocks mean for names. Each name once in each list, in order of NameId.
struct ChangedNames {
  std::vector<NameId> listed;     ///< defined elsewhere than before, or not
  std::vector<NameId> to_check;   ///< defined in a changed block, before or after, or called so as a parameter
  std::vector<NameId> reordered;  ///< the definition in force mentions other names, or is another one
  std::vector<NameId> mentioned;  ///< in a changed block, before or after; empty where all blocks are new
};

/// Brings the occurrences of names up to date. The users of names are listed with the first change of a document that
/// was checked before, not when all of it is new (`all_new`).
ChangedNames update_names(EngineState& state, const std::vector<BlockChange>& changes, bool all_new);

/// Adds what blocks mean that were read once more: they define what they did. `names` are sorted again.
void add_changed_names(EngineState& state, const std::vector<BlockChange>& changes, ChangedNames& names);

/// Lists for every name the blocks that mention it; those that are not read yet are left out.
void list_users(EngineState& state);

}  // namespace texbrdf
