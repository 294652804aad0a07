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

/// What a Text token says: its content with `\_` as `_`, white space folded, or dropped where TeX ignores it.
std::string read_text_token(std::string_view token);
/// \text{…} around the content.
std::string spell_text(std::string_view content);

/// "vec" for all decorations that make a vector's name, else the command without its backslash.
std::string_view decoration_name(const ParsedBlock& block, uint32_t token);

/// The index behind the symbol, decorated symbol or group that begins at `token`, at most `end`.
uint32_t behind_argument(const ParsedBlock& block, uint32_t token, uint32_t end);

/// The index behind the bracket that closes the one at `open`, at most `end`.
uint32_t behind_closer(const ParsedBlock& block, uint32_t open, uint32_t end);

}  // namespace texbrdf
