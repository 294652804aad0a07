#pragma once

#include <string>

#include "ir/graph.h"
#include "ir/program.h"

namespace texbrdf::ir {

/// One value a line: `%3: ℝ = multiply %1 %2`. Equal for equal graphs.
std::string print_graph(const Graph& graph);
std::string print_program(const Program& program);

}  // namespace texbrdf::ir
