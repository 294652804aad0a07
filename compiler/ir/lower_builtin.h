#pragma once

#include <span>

#include "ir/graph.h"
#include "semantics/builtin_functions.h"

namespace texbrdf::ir {

/// The logarithm to the base.
ValueId add_logarithm(Graph& graph, ValueId operand, ValueId base);
/// A call of a built-in function with arguments that fit its signature; colours are taken component by component.
ValueId lower_builtin(Graph& graph, Builtin function, std::span<const ValueId> arguments);

}  // namespace texbrdf::ir
