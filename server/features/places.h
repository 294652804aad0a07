#pragma once

#include <cstdint>
#include <string>

#include "analysis/snapshot.h"

namespace texbrdf::features {

/// Absolute range of a node of the block.
Span node_span(const Snapshot& snapshot, BlockId block, NodeId node);
/// Left side, `=` and right side; in the document, or relative to the block.
Span definition_span(const Snapshot& snapshot, DefinitionId id);
Span definition_span(const ParsedBlock& block, const DefinitionSyntax& definition);
/// The defined name on the left side.
Span name_span(const Snapshot& snapshot, DefinitionId id);
/// "line 3", counted from 1 as people do, "line 3 of another file".
std::string line_name(const Snapshot& snapshot, uint32_t offset);

}  // namespace texbrdf::features
