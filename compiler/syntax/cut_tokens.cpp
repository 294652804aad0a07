#include "syntax/cut_tokens.h"

namespace texbrdf {

void cut_tokens(std::pmr::vector<Token>& tokens, std::span<const uint32_t> cuts) {
  std::pmr::vector<Token> parts(tokens.get_allocator());
  parts.reserve(tokens.size() + cuts.size());
  size_t next = 0;
  for (Token token : tokens) {
    while (next < cuts.size() && cuts[next] < token.span.begin) ++next;
    const bool is_at_cut = next < cuts.size() && cuts[next] == token.span.begin;
    if (is_at_cut && token.kind == TokenKind::Accent) token.kind = TokenKind::Macro;
    for (; token.kind == TokenKind::Word && next < cuts.size() && cuts[next] < token.span.end; ++next) {
      if (cuts[next] == token.span.begin) continue;
      parts.push_back(token);
      parts.back().span.end = cuts[next];
      token.span.begin = cuts[next];
    }
    parts.push_back(token);
  }
  tokens = std::move(parts);
}

}  // namespace texbrdf
