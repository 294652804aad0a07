#pragma once

#include <optional>

#include "ir/graph.h"

namespace texbrdf::ir {

/// How many panels integrals have: half of them tell how exact the result is.
enum class Fineness : uint8_t { Full, Half };

/// Integrals become sums over panels and over the points of a Gauss-Legendre rule in each. Nested integrals have fewer
/// panels each, so that the work stays bounded.
/// Nothing where the graph has too few binders left.
std::optional<Graph> expand_integrals(const Graph& graph, Fineness fineness);

}  // namespace texbrdf::ir
