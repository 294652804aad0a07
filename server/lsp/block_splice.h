#pragma once

#include <cstdint>

#include "analysis/snapshot.h"
#include "lsp/edited_region.h"

namespace texbrdf::lsp {

/// Blocks [first, before_end) of one snapshot became [first, after_end) of a later one; all others are the same.
struct BlockSplice {
  uint32_t first = 0;
  uint32_t before_end = 0;
  uint32_t after_end = 0;
};

/// Looks only at blocks near the edits, which all have to lie in the region.
BlockSplice find_splice(const Snapshot& before, const Snapshot& after, const EditedRegion& edited);

}  // namespace texbrdf::lsp
