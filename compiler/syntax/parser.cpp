#include "syntax/parser.h"

#include <algorithm>
#include <optional>

#include "syntax/operators.h"

namespace texbrdf {

/// The Definition node stands above the highest expression.
constexpr uint32_t kMaxExpressionHeight = kMaxTreeHeight - 1;

Parser::Parser(ParsedBlock& block, bool silent)
    : block_(block), tokens_(block.tokens.data()), block_is_silent_(silent) {
  block_.tree.reserve(static_cast<uint32_t>(block.tokens.size()) / 2 + 2);  // most equations have fewer nodes than that
}

void Parser::run() {
  const bool balance = brackets_balance(block_.tokens);
  const uint32_t end = static_cast<uint32_t>(block_.tokens.size()) - 1;
  std::optional<BracketFaults> faults;
  if (!balance) faults = find_bracket_faults(block_.tokens, 0, end);
  const std::vector<Statement> statements = split_statements(block_.tokens, block_.text, faults ? &*faults : nullptr);
  const bool passes_over = statements.size() > 1 || is_inline(block_.extent.region);
  for (size_t i = 0; i < statements.size(); ++i) {
    const Statement& statement = statements[i];
    const bool has_relation = statement.relation < statement.end;
    const bool defines = has_relation && tokens_[statement.relation].kind == TokenKind::Equals;
    if (!defines && (has_relation || passes_over)) continue;
    if (!balance) find_brackets(statement.begin, statement.end);
    const bool is_last = i + 1 == statements.size();
    const Span content = block_.extent.content;
    parse_statement(statement, {i == 0 ? content.begin : tokens_[statement.begin].span.begin,
                                is_last ? content.end : tokens_[statements[i + 1].begin].span.begin});
  }
  if (!is_inline(block_.extent.region)) report_ampersands();
}

TokenKind Parser::kind_behind(uint32_t token) const {
  do {
    token = std::min(token + 1, end_);
  } while (is_layout(kind_at(token)));
  return kind_at(token);
}

TokenKind Parser::kind_before(uint32_t token) const {
  do --token;
  while (token > 0 && is_layout(tokens_[token].kind));
  return tokens_[token].kind;
}

void Parser::continue_after(uint32_t closer) {
  position_ = closer;
  advance();
}

Parser::Part Parser::make(NodeKind kind, uint32_t token, uint32_t first_token, std::initializer_list<Part> children) {
  return make(kind, token, first_token, children.begin(), children.size());
}

Parser::Part Parser::make(NodeKind kind, uint32_t token, uint32_t first_token, const Part* children, size_t count) {
  constexpr size_t kNear = 8;
  NodeId near[kNear];
  std::vector<NodeId> far;
  if (count > kNear) far.resize(count);
  NodeId* const nodes = count > kNear ? far.data() : near;

  Part part{{}, 0, kind == NodeKind::Error};
  uint32_t end_token = position_;
  for (size_t i = 0; i < count; ++i) {
    nodes[i] = children[i].node;
    part.height = std::max(part.height, children[i].height + 1);
    part.damaged = part.damaged || children[i].damaged;
    end_token = std::max(end_token, block_.tree.node(nodes[i]).end_token);
  }
  if (part.height > kMaxExpressionHeight) {
    report_too_deep(token);
    return leaf(NodeKind::Error, token, token + 1);
  }
  while (end_token > first_token + 1 && is_layout(tokens_[end_token - 1].kind)) --end_token;
  part.node = block_.tree.add(kind, token, first_token, end_token, {nodes, count});
  return part;
}

/// Nothing is consumed; the node covers the token that stands here.
Parser::Part Parser::error_here() {
  return leaf(NodeKind::Error, position_, position_ + 1);
}

Parser::Part Parser::parse_expression(uint8_t min_power) {
  if (depth_ > kMaxExpressionHeight) {
    report_too_deep(position_);
    return error_here();
  }
  ++depth_;
  const Part expression = parse_infix(parse_operand(), min_power);
  --depth_;
  return expression;
}

Parser::Part Parser::parse_infix(Part left, uint8_t min_power) {
  for (;;) {
    skip_empty_groups();
    const TokenRole role = role_of(kind());
    if (role.infix != 0) {
      if (role.infix < min_power) return left;
      const uint32_t op = advance();
      recovering_ = false;
      const Part right = parse_expression(role.right_min);
      left = make(NodeKind::Infix, op, first_token(left), {left, right});
      if (role.infix == kPowerOperatorPower) report_power_chain(left);
    } else if (role.begins_operand || opens_bars()) {
      if (kJuxtapositionPower < min_power) return left;
      left = parse_factor_behind(left);
    } else if (at(TokenKind::Unknown)) {
      if (kJuxtapositionPower < min_power) return left;
      left = parse_unknown_between(left);
    } else {
      return left;
    }
  }
}

/// `{} + a`: what TeX needs for its spaces.
void Parser::skip_empty_groups() {
  while (at(TokenKind::OpenBrace) && kind_at(position_ + 1) == TokenKind::CloseBrace &&
         role_of(kind_behind(position_ + 1)).infix != 0) {
    advance();
    advance();
  }
}

/// A product without an operator.
Parser::Part Parser::parse_factor_behind(Part left) {
  const uint32_t second = position_;
  if (at(TokenKind::Number) && kind_before(second) == TokenKind::Number) report_missing_operator(second);
  const Part right = parse_expression(kJuxtapositionPower + 1);
  const bool damage = silent_ || left.damaged || right.damaged;
  if (damage) had_error_ = true;
  const Part product =
      make(damage ? NodeKind::Error : NodeKind::Juxtaposition, second, first_token(left), {left, right});
  if (!product.damaged) report_factor_behind_quotient(product);
  return product;
}

/// A character outside the language where an operator could stand: taken for a product's.
Parser::Part Parser::parse_unknown_between(Part left) {
  const uint32_t unknown = position_;
  report_unknown();
  while (at(TokenKind::Unknown)) advance();
  if (!role_of(kind()).begins_operand) return make(NodeKind::Error, unknown, first_token(left), {left});
  const Part right = parse_expression(kJuxtapositionPower + 1);
  return make(NodeKind::Error, unknown, first_token(left), {left, right});
}

Parser::Part Parser::parse_operand() {
  skip_empty_groups();
  return role_of(kind()).prefix != 0 ? parse_prefix() : parse_primary();
}

Parser::Part Parser::parse_prefix() {
  const uint8_t power = role_of(kind()).prefix;
  const uint32_t op = advance();
  const Part operand = parse_expression(power);
  return make(NodeKind::Prefix, op, op, {operand});
}

Parser::Part Parser::parse_primary() {
  switch (kind()) {
    case TokenKind::Number: {
      const uint32_t number = advance();
      return leaf(NodeKind::Number, number, number + 1);
    }
    case TokenKind::Word:
    case TokenKind::Macro:
    case TokenKind::Text:
      return parse_name_or_call();
    case TokenKind::Vec:
      return vector_literal_begins() ? parse_vector_literal() : parse_name_or_call();
    case TokenKind::Accent:
      return parse_name_or_call();
    case TokenKind::Function:
      return parse_function();
    case TokenKind::Extremum:
      return parse_extremum();
    case TokenKind::Frac:
      return parse_fraction();
    case TokenKind::Sqrt:
      return parse_root();
    case TokenKind::OpenBrace:
      return decorated_group_begins() ? parse_name_or_call() : parse_group();
    case TokenKind::OpenParen:
    case TokenKind::OpenBracket:
    case TokenKind::OpenSet:
      return parse_group();
    case TokenKind::OpenAngle:
      return parse_angles();
    case TokenKind::Bar:
    case TokenKind::DoubleBar:
      return parse_bars();
    case TokenKind::Unknown:
      return parse_unknown_operand();
    case TokenKind::Plus:
    case TokenKind::Minus:
    case TokenKind::Multiply:
    case TokenKind::Cross:
    case TokenKind::Divide:
    case TokenKind::Caret:
    case TokenKind::Underscore:
    case TokenKind::Prime:
    case TokenKind::Equals:
    case TokenKind::Comma:
    case TokenKind::CloseParen:
    case TokenKind::CloseBrace:
    case TokenKind::CloseBracket:
    case TokenKind::CloseSet:
    case TokenKind::CloseAngle:
    case TokenKind::Over:
    case TokenKind::Relation:
    case TokenKind::Ampersand:
    case TokenKind::Gap:
    case TokenKind::NewRow:
    case TokenKind::End:
      report_expected(Code::NoExpression);
      return error_here();
  }
  return error_here();
}

Parser::Part Parser::parse_unknown_operand() {
  const uint32_t unknown = position_;
  report_unknown();
  while (at(TokenKind::Unknown)) advance();
  if (!role_of(kind()).begins_operand) return leaf(NodeKind::Error, unknown, unknown + 1);
  const Part operand = parse_primary();
  return make(NodeKind::Error, unknown, unknown, {operand});
}

}  // namespace texbrdf
