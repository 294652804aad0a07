#pragma once

#include <string>
#include <string_view>

#include "syntax/parsed_block.h"

namespace texbrdf::features {

/// A new name as it has to be written in the place of a Name node: apart from letters and digits that would become part
/// of it, and in braces where LaTeX would take only its first symbol.
std::string spelled_in_place(const ParsedBlock& block, NodeId place, std::string_view name);

}  // namespace texbrdf::features
