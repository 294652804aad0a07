#pragma once

#include <vector>

#include "analysis/snapshot.h"

namespace texbrdf::features {

/// What of a block can be folded away.
struct Fold {
  Span inside;           ///< from behind its \begin{…} to its \end, or to the last that stands in it
  bool has_end = false;  ///< an \end follows, which stays to be seen
};

/// The blocks that go over several lines, in document order.
std::vector<Fold> folding_ranges(const Snapshot& snapshot);

}  // namespace texbrdf::features
