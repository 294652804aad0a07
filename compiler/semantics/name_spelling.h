#pragma once

#include <string>
#include <string_view>

#include "syntax/parsed_block.h"

namespace texbrdf {

/// Tokens [first, end) of a name or a subscript in one normal form: no spaces that mean nothing, no braces around a
/// single symbol, braces around everything longer. Iterative, because subscripts nest without limit.
std::string normal_tokens(const ParsedBlock& block, uint32_t first, uint32_t end);

/// `_x`, `_\alpha` or `_{…}` for a subscript without braces.
std::string subscript_suffix(std::string_view subscript);

/// What a Text token says: its command, and its content with `\_` as `_` and white space folded.
struct TextToken {
  bool is_roman = false;
  std::string content;
};
TextToken read_text_token(std::string_view token);
/// \text{…} or \mathrm{…} around the content.
std::string spell_text(const TextToken& text);

/// The index behind the bracket that closes the one at `open`, at most `end`.
uint32_t behind_closer(const ParsedBlock& block, uint32_t open, uint32_t end);

}  // namespace texbrdf
