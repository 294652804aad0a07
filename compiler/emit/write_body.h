#pragma once

#include <set>
#include <vector>

#include "emit/code.h"
#include "emit/helpers.h"
#include "emit/ranges.h"
#include "emit/scope.h"
#include "ir/graph.h"

namespace texbrdf::emit {

/// Statements that give each root of `graph` to its item, in order of the items, and each local just before the first
/// equation that needs it. `formals_can_fail`: one for each formal of the function; nullptr for the entry point.
std::vector<Statement> write_body(ExpressionPool& pool, const ir::Graph& graph, const ProgramRanges& ranges,
                                  const std::vector<bool>* formals_can_fail, const std::vector<BodyItem>& items,
                                  FunctionScope& scope, std::set<HelperUse>& helpers);

}  // namespace texbrdf::emit
