#include "features/rename_spelling.h"

#include <algorithm>

#include "source/characters.h"

namespace texbrdf::features {
namespace {

/// `\cos` and `x` would be one command, `x_1` and `2` one subscript, `2` and `e` the start of a number.
bool would_join(char left, char right) {
  if (is_letter(left) && is_letter(right)) return true;
  const bool continues_number = is_digit(right) || right == '.' || right == 'e' || right == 'E';
  return (is_digit(left) || left == '.') && continues_number;
}

bool is_one_symbol(std::string_view name) {
  return name.size() == 1 || (name.front() == '\\' && std::all_of(name.begin() + 1, name.end(), is_letter));
}

/// Behind `^` and `\sqrt`; a call is read as a whole there.
bool takes_one_symbol(const ParsedBlock& block, const Node& place) {
  if (place.first_token == 0 || block.tokens[place.end_token].kind == TokenKind::OpenParen) return false;
  const TokenKind before = block.tokens[place.first_token - 1].kind;
  return before == TokenKind::Caret || before == TokenKind::Sqrt;
}

}  // namespace

std::string spelled_in_place(const ParsedBlock& block, NodeId place, std::string_view name) {
  if (takes_one_symbol(block, block.tree.node(place)) && !is_one_symbol(name)) {
    return std::string("{").append(name).append("}");
  }
  const Span span = block.span(place);
  std::string text;
  if (span.begin > 0 && would_join(block.text[span.begin - 1], name.front())) text += ' ';
  text += name;
  if (span.end < block.text.size() && would_join(name.back(), block.text[span.end])) text += ' ';
  return text;
}

}  // namespace texbrdf::features
