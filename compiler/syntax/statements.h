#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "syntax/brackets.h"
#include "syntax/token.h"

namespace texbrdf {

/// One equation of a block: tokens [begin, end) that the parser reads by themselves. A block has several where rows,
/// commas, \quad or words like \text{where} stand between them.
struct Statement {
  uint32_t begin = 0;
  uint32_t end = 0;       ///< the token that ends it: a separator, or the block's End
  uint32_t relation = 0;  ///< its first `=`, `<` …; `end` where it has none
  uint32_t chain = 0;     ///< the relation that ends the first right side; else `end`
  bool is_part = false;   ///< stands in a chain: in force where nothing else defines the name
};

/// A row that starts with an operator or a relation continues the one before; what stands in brackets belongs together
/// wherever the rows end. Punctuation at the end of a statement is left out. There is at least one, perhaps empty.
/// `text` is what the tokens' spans are of; `faults`, of all tokens, where their brackets do not balance.
std::vector<Statement> split_statements(std::span<const Token> tokens, std::string_view text,
                                        const BracketFaults* faults);

}  // namespace texbrdf
