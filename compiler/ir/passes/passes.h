#pragma once

#include <span>
#include <string_view>

#include "ir/graph.h"
#include "ir/program.h"

namespace texbrdf::ir {

// Every pass maps a graph to one with the same meaning for all real inputs, up to rounding; roots keep their order.
// docs/numerics.md says what holds for NaN, infinities and zeros. Each has its own .cpp in this folder.

/// cos, sin and tan of a convention's angle, or of sums, differences and doubles of such, become dot products:
/// cos(theta_h) is clamp(N·H), no arccos is left.
Graph angles_to_dot_products(const Graph& graph);
/// Conventions become what conventions.def says they are made of: only inputs are left as Convention.
Graph expand_conventions(const Graph& graph);
/// The same for conventions that a function's parameter has taken along, and only those: the others have a name.
Graph expand_shadowed_conventions(const Graph& graph);
/// Values of constants only become constants where they are finite; neutral elements vanish where that changes no
/// value, NaN and infinity included.
Graph fold_constants(const Graph& graph);
/// Powers with a constant integer exponent from -8 to 8 become products; x^0.5 becomes sqrt where equal.
Graph expand_powers(const Graph& graph);
/// Equal values become one.
Graph share_common_subexpressions(const Graph& graph);
/// Only what a root needs stays.
Graph remove_dead_values(const Graph& graph);

struct Pass {
  std::string_view name;
  Graph (*run)(const Graph&);
};

/// The passes for evaluation, in order.
std::span<const Pass> evaluation_passes();
/// The passes for generated code, in order: conventions stay named where they are read as such.
std::span<const Pass> emission_passes();

/// Runs passes in order; validates after each in debug builds.
Graph run_passes(Graph graph, std::span<const Pass> passes);
/// The same for each definition of a program.
Program run_passes(Program program, std::span<const Pass> passes);

}  // namespace texbrdf::ir
