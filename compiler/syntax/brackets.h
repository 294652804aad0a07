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

  uint32_t first = 0;              ///< token of the stretch that was searched
  std::vector<uint32_t> partners;  ///< by token from `first` on

  /// The closer of an opener, UINT32_MAX where there is none.
  uint32_t partner_of(uint32_t opener) const { return partners[opener - first]; }
};

/// Of the tokens [first, end); one stands behind them.
BracketFaults find_bracket_faults(std::span<const Token> tokens, uint32_t first, uint32_t end);

}  // namespace texbrdf
