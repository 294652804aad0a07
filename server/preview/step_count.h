#pragma once

#include <span>

#include "eval/evaluate.h"
#include "ir/graph.h"

namespace texbrdf::preview {

/// How many values one evaluation of a flattened graph computes at most, those of a reduction's body once for each
/// iteration. A reduction whose bounds are no numbers and no parameters counts as the longest there is.
double most_steps(const ir::Graph& graph, std::span<const eval::Triple> parameters);

}  // namespace texbrdf::preview
