#pragma once

#include <cstdint>
#include <memory_resource>
#include <string_view>
#include <vector>

#include "source/span.h"
#include "syntax/token.h"

namespace texbrdf {

struct LexedContent {
  std::pmr::vector<Token> tokens;   ///< closed by one End token with the span `end`
  std::pmr::vector<Span> comments;  ///< `%` to the end of its line
};

/// Splits `content`, a part of `text`, into tokens. Never fails: what is outside the language becomes Unknown tokens of
/// one code point, an environment that is no math_regions.def's and `\verb|…|` one Unknown token each, `\text` without
/// its group an Unknown token. `has_columns`: `&` separates columns.
LexedContent lex(std::string_view text, Span content, bool has_columns, Span end,
                 std::pmr::memory_resource* memory = std::pmr::get_default_resource());

}  // namespace texbrdf
