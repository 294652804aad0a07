#pragma once

#include <cstdint>
#include <vector>

#include "ir/graph.h"

namespace texbrdf::eval {

/// One step of a walk that computes the roots of a graph. A branch of a Select and the body of a Sum or Product are
/// regions: consecutive steps that are left out, or repeated.
struct Step {
  enum class Kind : uint8_t {
    Compute,    ///< compute `value`; of a Select: choose between the branches, of which one may not have been computed
    IfTrue,     ///< steps up to `target` are needed only where the condition of the Select `value` is true
    IfFalse,    ///< … is false
    BeginLoop,  ///< start the reduction `value`; `target` is the step behind its EndLoop
    EndLoop,    ///< add the body to the reduction, go on at `target`, the first step of the body
  };
  Kind kind;
  ir::ValueId value;
  uint32_t target = 0;
};

/// Every value that a root needs stands once, behind its operands, in the innermost region that holds all its uses, but
/// outside of reductions on whose variable it does not depend.
struct Schedule {
  std::vector<Step> steps;
  std::vector<uint32_t> root_end;  ///< steps [0, root_end[k]) are enough for roots[k]
};

/// Precondition: a binder belongs to one Sum or Product, and only the body of that one depends on it.
/// Iterative, O(n log n): a chain of any length is ordinary.
Schedule schedule(const ir::Graph& graph);

}  // namespace texbrdf::eval
