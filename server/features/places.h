#pragma once

#include <cstdint>
#include <optional>
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
/// The definition that is shown for a name that stands for others: the first of those with an index, the function of a
/// derivative.
std::optional<DefinitionId> stood_for(const Snapshot& snapshot, const Occurrence& occurrence);
/// A parameter as messages show it: its name, `\cos\theta`, or the expression that it is written as.
std::string parameter_text(const Snapshot& snapshot, BlockId block, const CheckedParameter& parameter);
/// "line 3", counted from 1 as people do, "line 3 of another file".
std::string line_name(const Snapshot& snapshot, uint32_t offset);

}  // namespace texbrdf::features
