#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "syntax/token.h"

namespace texbrdf {

/// The closer of an opener; Unknown for any other kind.
TokenKind closer_of(TokenKind opener);
bool is_opener(TokenKind kind);
bool is_closer(TokenKind kind);

/// Whether every bracket of the tokens has its partner.
bool brackets_balance(std::span<const Token> tokens);

/// An opener that is left open, with all that it holds.
struct UnclosedBracket {
  uint32_t opener = 0;
  uint32_t found = 0;  ///< the token that stands where its closer should: another closer, or End
  uint32_t reach = 0;  ///< the token where what encloses it ends, so that it cannot go on
};

/// How brackets that do not balance are best understood: as few damaged regions as possible.
struct BracketFaults {
  std::vector<UnclosedBracket> unclosed;  ///< the outermost ones only, in order
  std::vector<uint32_t> stray_closers;    ///< in order, to be reported
  std::vector<uint32_t> ignored_closers;  ///< all closers without partner; some belong to an unclosed bracket
  std::vector<uint32_t> partners;         ///< by token: the closer of an opener, UINT32_MAX where there is none
};

BracketFaults find_bracket_faults(std::span<const Token> tokens);

}  // namespace texbrdf
