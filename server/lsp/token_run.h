#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "features/semantic_tokens.h"
#include "source/source_text.h"

namespace texbrdf::lsp {

/// The semantic tokens of one block as the protocol's numbers, five a token, each token's place told from the one
/// before. Only the place of the first depends on what stands before the block, so it is left out here.
struct TokenRun {
  uint32_t count = 0;
  Position first;       ///< of the first token's begin, from the block's begin: `advanced` gives it in the document
  Position last;        ///< of the last token's begin
  std::string numbers;  ///< JSON without brackets; lacks the first two numbers
  friend bool operator==(const TokenRun&, const TokenRun&) = default;
};

inline constexpr uint32_t kNumbersPerToken = 5;
/// The numbers that tell a token's place.
inline constexpr uint32_t kNumbersPerPlace = 2;

/// `text` is the block's. Tokens are in order, each within a line.
TokenRun encode_run(std::string_view text, std::span<const features::SemanticToken> tokens, ColumnUnit unit);

/// Where one comes from `begin` by going on so many lines and columns.
constexpr Position advanced(Position begin, Position by) {
  return by.line == 0 ? Position{begin.line, begin.column + by.column} : Position{begin.line + by.line, by.column};
}
/// The inverse for `to` not before `from`: what the protocol writes of a token behind another.
constexpr Position distance(Position from, Position to) {
  return to.line == from.line ? Position{0, to.column - from.column} : Position{to.line - from.line, to.column};
}

/// "line,column"
void append_place(std::string& out, Position place);

}  // namespace texbrdf::lsp
