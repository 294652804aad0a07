#pragma once

#include <string>

#include "syntax/parsed_block.h"

namespace texbrdf {

/// One definition on one line, fully parenthesised, as language.md section 3 says: `a = 1+2` gives `a=(1+2)`.
/// Parses back to the same tree. Precondition: definition.readable.
std::string print_source(const ParsedBlock& block, const DefinitionSyntax& definition);

}  // namespace texbrdf
