#pragma once

#include <map>
#include <string>

#include "ir/graph.h"

namespace texbrdf::emit {

/// A graph, and the values in it that have a name of their own in optics: cos_theta_h, sin_phi_i …
struct GraphWithDirections {
  ir::Graph graph;
  std::map<ir::ValueId, std::string> names;
};

/// `expand_angles`: polar angles become arccosines, so that they share their cosines with the rest.
GraphWithDirections name_directions(const ir::Graph& graph, bool expand_angles);

}  // namespace texbrdf::emit
