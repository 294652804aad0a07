#pragma once

#include <functional>
#include <vector>

#include "ir/program.h"

namespace texbrdf::ir {

/// What a name became in the program: a parameter, or a definition; one of an aggregate type became several, in the
/// order of its entries, of which this is the first.
struct LinkTarget {
  Op op = Op::Reference;  ///< Reference or Parameter
  uint32_t index = 0;
};

/// What a Reference or Call of a graph that is not linked is of.
Instance used(const Graph& graph, const Value& value);

/// The graph of a definition with its references and calls in terms of the program: one graph for each entry of its
/// type, and no aggregate in them.
std::vector<Graph> link_entries(const Graph& graph, const std::function<LinkTarget(const Instance&)>& target);

/// The definition without its graph as the program has it: each entry of an aggregate is a parameter of its own.
ProgramDefinition program_definition(const LinkableDefinition& definition);
/// The name of an entry of an aggregate: `M_{12}`, `m_1`.
Name entry_name(const Name& name, Shape shape, uint32_t index);

}  // namespace texbrdf::ir
