#pragma once

#include <cstdint>
#include <vector>

#include "ir/graph.h"

namespace texbrdf::eval {

/// Which components of each value a root depends on: bit i for component i; a real or truth has bit 0.
std::vector<uint8_t> demanded_components(const ir::Graph& graph);

}  // namespace texbrdf::eval
