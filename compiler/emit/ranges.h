#pragma once

#include <vector>

#include "ir/program.h"

namespace texbrdf::emit {

/// What is known of a real value for unit directions and finite parameters, up to rounding.
struct Range {
  double least;
  double most;
  /// It can be NaN for a whole region of inputs: a root or logarithm of negative numbers and the like. Single points
  /// such as 0/0 do not count.
  bool can_fail;
};

/// What is known of the definitions of a program.
struct ProgramRanges {
  std::vector<Range> definitions;                   ///< of their values; of triples, of their length
  std::vector<std::vector<bool>> formals_can_fail;  ///< by definition and position: some caller passes such a value
};

ProgramRanges find_ranges(const ir::Program& program);
/// By value of `graph`, in which `formals_can_fail` (one for each formal) holds.
std::vector<Range> find_ranges(const ir::Graph& graph, const ProgramRanges& program,
                               const std::vector<bool>& formals_can_fail);

}  // namespace texbrdf::emit
