#pragma once

#include <string>

#include "syntax/parsed_block.h"

namespace texbrdf {

/// One token a line: `begin-end Kind text`, offsets in the block.
std::string print_tokens_text(const ParsedBlock& block);

/// One node a line, children indented below it: `Kind begin-end text of its token`. The definitions first, then, where
/// there is none, the nodes that no other holds.
std::string print_tree_text(const ParsedBlock& block);

}  // namespace texbrdf
