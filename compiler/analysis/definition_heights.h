#pragma once

#include <vector>

#include "analysis/engine_state.h"
#include "analysis/working_blocks.h"

namespace texbrdf {

/// What putting names in order has changed.
struct OrderChange {
  std::vector<NameId> knotted;  ///< came into a knot or out of one
  /// Where all were put in order: the names with a definition in force, each behind those that it mentions.
  std::vector<NameId> order;
};

/// Brings the heights of names, knots and cycles up to date after the definitions of the names `reordered` have come to
/// mention others.
///
/// Heights only grow (as in Jane Street's Incremental): an edge from a low definition to a high one lifts the low one
/// and those that mention it. Where that takes too long, or some definition needs itself, all are put in order anew.
OrderChange order_definitions(EngineState& state, const WorkingBlocks& blocks, const std::vector<NameId>& reordered);

}  // namespace texbrdf
