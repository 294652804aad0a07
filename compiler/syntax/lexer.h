#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "source/span.h"
#include "syntax/token.h"

namespace texbrdf {

struct LexedContent {
  std::vector<Token> tokens;   ///< closed by one End token with the span `end`
  std::vector<Span> comments;  ///< `%` to the end of its line
};

/// Splits `content`, a part of `text`, into tokens. Never fails: what is outside the language becomes Unknown tokens of
/// one code point, `\begin{…}` with its environment one Unknown token, `\text` without its group an Unknown token.
LexedContent lex(std::string_view text, Span content, Span end);

}  // namespace texbrdf
