#include "syntax/split_subscripts.h"

#include <cstdint>

namespace texbrdf {
namespace {

bool is_split(const std::pmr::vector<Token>& tokens, size_t word) {
  return word > 0 && tokens[word].kind == TokenKind::Word && tokens[word].span.size() > 1 &&
         tokens[word - 1].kind == TokenKind::Underscore && tokens[word + 1].kind == TokenKind::Underscore;
}

void append_part(std::pmr::vector<Token>& tokens, Token word, uint32_t begin, uint32_t end) {
  if (begin == end) return;
  word.span = {begin, end};
  tokens.push_back(word);
}

}  // namespace

void split_subscripts(std::pmr::vector<Token>& tokens) {
  size_t first = 0;
  while (first + 1 < tokens.size() && !is_split(tokens, first)) ++first;
  if (first + 1 >= tokens.size()) return;
  std::pmr::vector<Token> split(tokens.begin(), tokens.begin() + static_cast<std::ptrdiff_t>(first),
                                tokens.get_allocator());
  for (size_t i = first; i < tokens.size(); ++i) {
    const Token& token = tokens[i];
    if (i + 1 == tokens.size() || !is_split(tokens, i)) {
      split.push_back(token);
      continue;
    }
    append_part(split, token, token.span.begin, token.span.begin + 1);
    append_part(split, token, token.span.begin + 1, token.span.end - 1);
    append_part(split, token, token.span.end - 1, token.span.end);
  }
  tokens = std::move(split);
}

}  // namespace texbrdf
