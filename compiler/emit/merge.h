#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "ir/graph.h"

namespace texbrdf::emit {

/// Joins graphs into one in which equal values are one value. Binder ids are kept: reductions of different graphs may
/// share one, and then what depends on it.
class Merger {
 public:
  /// The images of all values of `graph`; its roots become further roots.
  std::vector<ir::ValueId> append(const ir::Graph& graph);
  ir::Graph take() { return std::move(graph_); }

 private:
  ir::ValueId image(const ir::Value& value, std::span<const ir::ValueId> operands);

  ir::Graph graph_;
  std::map<std::vector<uint64_t>, ir::ValueId> known_;
};

}  // namespace texbrdf::emit
