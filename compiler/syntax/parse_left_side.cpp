#include <algorithm>

#include "syntax/control_words.h"
#include "syntax/parser.h"

namespace texbrdf {
namespace {

bool is_plain_name(TokenKind kind) {
  return kind == TokenKind::Word || kind == TokenKind::Macro || kind == TokenKind::Text;
}

/// Whether tokens [token, end) look like one name with its decoration, primes and subscripts.
bool is_name(const Token* tokens, uint32_t token, uint32_t end) {
  uint32_t open = 0;
  const auto kind = [&] { return token < end ? tokens[token].kind : TokenKind::End; };
  for (; is_decoration(kind()) || kind() == TokenKind::OpenBrace; ++token) {
    if (kind() == TokenKind::OpenBrace) ++open;
  }
  if (!is_plain_name(kind())) return false;
  for (++token; token < end; ++token) {
    if (kind() == TokenKind::CloseBrace) {
      if (open-- == 0) return false;
    } else if (kind() == TokenKind::Underscore) {
      ++token;
      uint32_t in_script = 0;
      do {
        if (kind() == TokenKind::OpenBrace) ++in_script;
        if (kind() == TokenKind::CloseBrace) --in_script;
      } while (in_script > 0 && ++token < end);
    } else if (kind() != TokenKind::Prime) {
      return false;
    }
  }
  return open == 0;
}

/// Brackets around a left side that are seen through; more are nonsense.
constexpr uint32_t kMostBrackets = 8;

/// Parameters that are expressions; a function with more is none.
constexpr uint32_t kMostExpressions = 16;

}  // namespace

/// Ends at the `=`, or at the statement's end where there is none. Braces around it mean nothing, as those of a colour
/// do.
Parser::LeftSide Parser::parse_left_side(const Statement& statement) {
  uint32_t end = statement.relation;
  LeftSide left;
  left.is_part = statement.is_part;
  const uint32_t first = position_;
  uint32_t closers = decorated_group_begins() ? 0 : enter_brackets(TokenKind::OpenBrace, end);
  if (function_of_name_begins(end)) {
    left.function = advance();
    closers += enter_brackets(TokenKind::OpenParen, end) + enter_brackets(TokenKind::OpenBrace, end);
    left.part = parse_name_leaf();
  } else if (const uint32_t caret = square_of_name(end); caret != kNone) {
    left.square = caret;
    left.part = parse_name_leaf();
    while (position_ < end) advance();
  } else {
    if (name_in_angles_begins(end)) angled_name_ = position_;
    left.part = parse_expression(0);
  }
  for (; closers > 0 && is_closer(kind()); --closers) advance();
  const bool is_wrapped = position_ > 0 && position_ == statement.relation && first != first_token(left.part);
  left.first_token = is_wrapped ? first : first_token(left.part);
  finish_left_side(statement, left.part);
  return left;
}

void Parser::finish_left_side(const Statement& statement, Part& left) {
  if (at(TokenKind::End)) {
    if (!left.damaged) report_expected(Code::MissingEquals);
    return;
  }
  const uint32_t equals = statement.relation;
  if (equals == end_) {
    report_expected(Code::UnexpectedToken);
    skip_to_end();
    return;
  }
  if (position_ != equals && !left.damaged) {
    report(Code::NoDefinition, statement.begin, join(tokens_[statement.begin].span, tokens_[equals - 1].span), {});
    left.damaged = true;
  }
  position_ = equals;
}

/// Passes over brackets around all that stands before `end`, which comes to lie at the innermost closer. Returns how
/// many there were.
uint32_t Parser::enter_brackets(TokenKind opener, uint32_t& end) {
  uint32_t entered = 0;
  for (; entered < kMostBrackets && at(opener) && end < end_; ++entered) {
    const uint32_t closer = closer_behind(position_, end);
    if (closer == kNone || closer != last_before(end)) break;
    const auto is_over = [](const Token& token) { return token.kind == TokenKind::Over; };
    if (std::any_of(tokens_ + position_, tokens_ + closer, is_over)) break;
    end = closer;
    advance();
  }
  return entered;
}

/// `\cos\xi` or `\cos(\theta_d)`, up to `end`.
bool Parser::function_of_name_begins(uint32_t end) const {
  if (!at(TokenKind::Function) || !is_trigonometric(tokens_[position_].command) || end >= end_) return false;
  uint32_t name = position_ + 1;
  uint32_t last = last_before(end);
  const bool has_brackets = (kind_at(name) == TokenKind::OpenParen || kind_at(name) == TokenKind::OpenBrace) &&
                            closer_behind(name, end) == last;
  if (has_brackets) return is_name(tokens_, name + 1, last);
  return last >= name && is_name(tokens_, name, last + 1);
}

/// `\langle E\rangle`, perhaps with parameters.
bool Parser::name_in_angles_begins(uint32_t end) const {
  if (!at(TokenKind::OpenAngle) || end >= end_) return false;
  const uint32_t closer = closer_behind(position_, end);
  if (closer == kNone || !is_name(tokens_, position_ + 1, closer)) return false;
  const uint32_t last = last_before(end);
  return closer == last || (kind_at(closer + 1) == TokenKind::OpenParen && closer_behind(closer + 1, end) == last);
}

/// The `^` of `g^2` or `g_1^{2}`, up to `end`; kNone where something else stands there.
uint32_t Parser::square_of_name(uint32_t end) const {
  if (end >= end_ || end < position_ + 3) return kNone;
  const uint32_t last = last_before(end);
  const bool is_braced = kind_at(last) == TokenKind::CloseBrace;
  if (last < position_ + (is_braced ? 4 : 2)) return kNone;
  const uint32_t number = is_braced ? last - 1 : last;
  const uint32_t caret = is_braced ? number - 2 : number - 1;
  const bool is_square = caret > position_ && caret < number && kind_at(caret) == TokenKind::Caret &&
                         block_.token_text(number) == "2" && (!is_braced || kind_at(caret + 1) == TokenKind::OpenBrace);
  return is_square && is_name(tokens_, position_, caret) ? caret : kNone;
}

/// The bracket that closes `opener` before `end`, else kNone.
uint32_t Parser::closer_behind(uint32_t opener, uint32_t end) const {
  uint32_t open = 0;
  for (uint32_t token = opener; token < end; ++token) {
    if (is_opener(kind_at(token))) ++open;
    if (is_closer(kind_at(token)) && --open == 0) return token;
  }
  return kNone;
}

uint32_t Parser::last_before(uint32_t token) const {
  do --token;
  while (token > 0 && is_layout(tokens_[token].kind));
  return token;
}

/// A name, or a name with parameters in parentheses.
bool Parser::defines_something(const Part& left) const {
  if (left.damaged) return false;
  const SyntaxTree& tree = block_.tree;
  if (tree.node(left.node).kind == NodeKind::Name) return true;
  if (tree.node(left.node).kind != NodeKind::Apply) return false;
  const std::span<const NodeId> parameters = tree.children(left.node).subspan(1);
  const auto is_expression = [&](NodeId id) { return tree.node(id).kind != NodeKind::Name; };
  return std::ranges::all_of(parameters, [this](NodeId id) { return is_parameter(id); }) &&
         std::ranges::count_if(parameters, is_expression) <= kMostExpressions;
}

/// A name, `\cos\theta`, or two names with an operator between: `\phi_r - \phi_i`, `\mathbf v \cdot \mathbf h`.
bool Parser::is_parameter(NodeId parameter) const {
  if (block_.parameter_name(parameter).valid()) return true;
  const SyntaxTree& tree = block_.tree;
  const auto is_around = [](NodeKind kind) {
    return kind == NodeKind::Group || kind == NodeKind::Bars || kind == NodeKind::Angles;
  };
  while (is_around(tree.node(parameter).kind) && tree.node(parameter).child_count == 1) {
    parameter = tree.child(parameter, 0);
  }
  const Node& node = tree.node(parameter);
  if (node.kind != NodeKind::Infix) return false;
  const TokenKind op = tokens_[node.token].kind;
  const bool joins = op == TokenKind::Plus || op == TokenKind::Minus || op == TokenKind::Multiply;
  return joins &&
         std::ranges::all_of(tree.children(parameter), [&](NodeId id) { return tree.node(id).kind == NodeKind::Name; });
}

}  // namespace texbrdf
