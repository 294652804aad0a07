#include <algorithm>
#include <string>
#include <vector>

#include "syntax/operators.h"
#include "syntax/parser.h"

namespace texbrdf {

/// The first token behind the script whose `_` or `^` stands here.
uint32_t Parser::behind_script() const {
  uint32_t token = position_ + 1;
  while (kind_at(token) == TokenKind::Vec || kind_at(token) == TokenKind::Accent) ++token;
  if (kind_at(token) != TokenKind::OpenBrace) return std::min(token + 1, end_);
  for (uint32_t open = 0; token < end_; ++token) {
    if (is_opener(tokens_[token].kind)) ++open;
    if (is_closer(tokens_[token].kind) && --open == 0) return token + 1;
  }
  return token;
}

Parser::Part Parser::needs_bound(uint32_t token, uint32_t command) {
  report(Code::MissingBound, token, {std::string(block_.token_text(command))});
  return leaf(NodeKind::Error, command, command + 1);
}

/// `\sum_{k=1}^{N} a_k b` is all of the product behind it; a `+` or `-` ends it.
Parser::Part Parser::parse_big_operator() {
  const uint32_t command = advance();
  Part name = leaf(NodeKind::Error, command, command + 1);
  const Part range = parse_index_range(command, name);
  const Part body = parse_expression(kJuxtapositionPower);
  const bool damage = name.damaged || range.damaged;
  return make(damage ? NodeKind::Error : NodeKind::BigOperator, command, command, {name, range, body});
}

/// `_{k=1}^{N}` or `_{k \in \{1, 2\}}`.
Parser::Part Parser::parse_index_range(uint32_t command, Part& name) {
  if (!at(TokenKind::Underscore)) return needs_bound(position_, command);
  const uint32_t behind = behind_script();
  const bool has_last = kind_at(behind) == TokenKind::Caret;
  advance();
  if (!at(TokenKind::OpenBrace)) {
    position_ = behind;
    skip_ignored();
    const Part missing = needs_bound(behind - 1, command);
    if (has_last) parse_last(command);
    return missing;
  }
  const uint32_t opener = advance();
  const bool begins_name = at(TokenKind::Word) || at(TokenKind::Macro) || at(TokenKind::Text);
  if (begins_name) name = parse_name_leaf();
  const bool is_set =
      at(TokenKind::Relation) && block_.token_text(position_) == "\\in" && kind_behind(position_) == TokenKind::OpenSet;
  if (!begins_name || (!is_set && (!at(TokenKind::Equals) || !has_last))) {
    const Part missing = needs_bound(command, command);
    continue_after(behind - 1);
    if (has_last) parse_last(command);
    return missing;
  }
  advance();
  recovering_ = false;
  const Part first = is_set ? parse_index_set() : parse_expression(0);
  const bool closed = close(opener);
  if (is_set) return first;
  const Part last = parse_last(command);
  return make(closed ? NodeKind::Range : NodeKind::Error, command, first_token(first), {first, last});
}

Parser::Part Parser::parse_index_set() {
  const uint32_t opener = advance();
  return parse_list(NodeKind::Set, opener, opener, opener);
}

/// `^N`, `^{N - 1}`.
Parser::Part Parser::parse_last(uint32_t owner) {
  advance();
  recovering_ = false;
  return parse_bound(owner);
}

Parser::Part Parser::parse_bound(uint32_t owner) {
  if (kind_at(position_) == TokenKind::Macro && block_.token_text(position_) == "\\infty") {
    const Part missing = needs_bound(position_, owner);
    advance();
    return missing;
  }
  const bool is_infinite = at(TokenKind::OpenBrace) && kind_behind(position_) == TokenKind::Macro &&
                           block_.token_text(position_ + 1) == "\\infty";
  if (!is_infinite) return parse_braced(owner);
  const Part missing = needs_bound(position_ + 1, owner);
  advance();
  advance();
  if (at(TokenKind::CloseBrace)) advance();
  return missing;
}

/// Bounds as `_0^1`, or what is integrated over: `_\Omega`, `_{\mathcal{H}^2}`.
Parser::Part Parser::parse_integration_range(uint32_t command) {
  if (!at(TokenKind::Underscore)) return needs_bound(command, command);
  const uint32_t behind = behind_script();
  if (kind_at(behind) != TokenKind::Caret) return parse_domain(behind);
  advance();
  const Part lower = parse_bound(command);
  if (!at(TokenKind::Caret)) return needs_bound(command, command);
  const Part upper = parse_last(command);
  return make(NodeKind::Range, command, first_token(lower), {lower, upper});
}

Parser::Part Parser::parse_domain(uint32_t end) {
  const uint32_t underscore = position_;
  const uint32_t first = underscore + 1;
  position_ = std::min(end, end_);
  skip_ignored();
  if (first >= end_) return needs_bound(underscore, underscore);
  return leaf(NodeKind::Domain, first, std::min(end, end_));
}

/// `\int_a^b f\,dx`, `\int_a^b dx\,f` and `\int_a^b \frac{dx}{f}`.
Parser::Part Parser::parse_integral() {
  const bool is_closed = at(TokenKind::Integral);
  const uint32_t command = advance();
  const Part range = parse_integration_range(command);
  Part variable;
  const Part body = parse_integrand(is_closed, variable);
  if (!variable.node.valid()) {
    if (!range.damaged && !body.damaged) report(Code::MissingDifferential, command, {});
    return make(NodeKind::Error, command, command, {range, body});
  }
  const bool damage = range.damaged || variable.damaged;
  return make(damage ? NodeKind::Error : NodeKind::Integral, command, command, {range, body, variable});
}

Parser::Part Parser::parse_integrand(bool is_closed, Part& variable) {
  recovering_ = false;
  if (at(TokenKind::Differential)) {
    const uint32_t sign = position_;
    variable = parse_variable();
    if (role_of(kind()).begins_operand || role_of(kind()).prefix != 0) return parse_expression(kJuxtapositionPower);
    return leaf(NodeKind::Differential, sign, sign + 1);
  }
  const size_t first_differential = differentials_.size();
  const Part body = parse_expression(is_closed ? 0 : kJuxtapositionPower);
  if (at(TokenKind::Differential)) {
    variable = parse_variable();
  } else if (differentials_.size() > first_differential) {
    const uint32_t behind = position_;
    position_ = differentials_[first_differential];
    differentials_.erase(differentials_.begin() + static_cast<ptrdiff_t>(first_differential));
    variable = parse_variable();
    position_ = behind;
  }
  return body;
}

/// The name behind the `d`.
Parser::Part Parser::parse_variable() {
  advance();
  recovering_ = false;
  return parse_name_leaf();
}

/// `dx` in a numerator. Its name is read by the integral.
Parser::Part Parser::parse_differential_factor() {
  const uint32_t sign = position_;
  differentials_.push_back(sign);
  advance();
  if (parse_name()) return make(NodeKind::Differential, sign, sign, {});
  return make(NodeKind::Error, sign, sign, {});
}

/// `\frac{d}{dx} f`, `\frac{d f}{dx}`, `\frac{d^2}{dx^2} f` and the same with `\partial`.
Parser::Part Parser::parse_derivative() {
  const uint32_t command = advance();
  const uint32_t numerator = advance();
  advance();  // d
  recovering_ = false;
  if (at(TokenKind::Caret)) continue_after(behind_script() - 1);
  const bool is_operator = at(TokenKind::CloseBrace);
  Part body;
  if (!is_operator) body = parse_inside();
  if (!close(numerator) || !at(TokenKind::OpenBrace)) return make(NodeKind::Error, command, command, {});
  const uint32_t denominator = advance();
  std::vector<DerivativeVariable> variables;
  while (at(TokenKind::Differential)) {
    if (!is_operator && !variables.empty()) {
      body = make_derivative(command, body, variables.back());
      variables.pop_back();
    }
    variables.push_back(parse_derivative_variable());
  }
  const bool closed = close(denominator);
  if (is_operator) body = parse_expression(kJuxtapositionPower);
  for (; !variables.empty(); variables.pop_back()) body = make_derivative(command, body, variables.back());
  return closed ? body : make(NodeKind::Error, command, command, {body});
}

/// `dx` or `dx^2`.
Parser::DerivativeVariable Parser::parse_derivative_variable() {
  DerivativeVariable variable{.name = parse_variable()};
  if (at(TokenKind::Caret)) {
    const uint32_t caret = advance();
    variable.order = parse_braced(caret);
  }
  return variable;
}

/// No other variable of the same fraction may have a node between those of the body.
Parser::Part Parser::make_derivative(uint32_t command, const Part& body, const DerivativeVariable& variable) {
  const NodeKind kind = variable.name.damaged ? NodeKind::Error : NodeKind::Derivative;
  if (!variable.order) return make(kind, command, command, {body, variable.name});
  return make(kind, command, command, {body, variable.name, *variable.order});
}

}  // namespace texbrdf
