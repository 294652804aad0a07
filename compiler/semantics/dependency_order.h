#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace texbrdf {

/// Lists of indices, one after the other: the list of i is targets[starts[i], starts[i + 1]).
struct AdjacencyLists {
  std::vector<uint32_t> starts = {0};
  std::vector<uint32_t> targets;

  uint32_t size() const { return static_cast<uint32_t>(starts.size() - 1); }
  std::span<const uint32_t> of(uint32_t index) const {
    return std::span(targets).subspan(starts[index], starts[index + 1] - starts[index]);
  }
  /// Ends the list that `targets` was appended to.
  void close_list() { starts.push_back(static_cast<uint32_t>(targets.size())); }
};

/// Definitions in an order in which each comes after all that it mentions, and the cycles. Iterative: a chain of any
/// length is ordinary.
struct DependencyOrder {
  std::vector<uint32_t> order;                ///< every index once; members of a cycle stand together
  std::vector<std::vector<uint32_t>> cycles;  ///< a real path a → b → … (→ a) each, from its smallest index
  std::vector<std::vector<uint32_t>> knots;   ///< for each cycle all indices that are on one with its members
};

/// `edges`: the indices that each definition mentions. One cycle is told of each knot (strongly connected component).
DependencyOrder dependency_order(const AdjacencyLists& edges);

}  // namespace texbrdf
