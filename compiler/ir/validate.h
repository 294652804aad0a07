#pragma once

#include <optional>
#include <string>

#include "ir/graph.h"
#include "ir/program.h"

namespace texbrdf::ir {

/// The first broken rule of ops.def (operand order and count, types, binders, payload ranges), or nothing.
std::optional<std::string> find_fault(const Graph& graph);
std::optional<std::string> find_fault(const Program& program);
/// Throws InternalError with the fault and `where`.
void validate(const Graph& graph, const char* where);

}  // namespace texbrdf::ir
