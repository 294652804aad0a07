#pragma once

#include <string>

#include "syntax/parsed_block.h"

namespace texbrdf {

/// The text of a node on one line: white space folded, without comments, labels and numbers.
std::string one_line(const ParsedBlock& block, NodeId id);

}  // namespace texbrdf
