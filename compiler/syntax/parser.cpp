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
    const Statement* const next = is_last ? nullptr : &statements[i + 1];
    const Span stretch{i == 0 ? content.begin : tokens_[statement.begin].span.begin,
                       is_last ? content.end : tokens_[statements[i + 1].begin].span.begin};
    parse_statement(statement, next, stretch);
    if (const auto angle = angle_in_chain(statement)) parse_statement(*angle, next, stretch);
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
  position_ = std::min(closer, end_);
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
  while (end_token > first_token + 1 && means_nothing_at_end(tokens_[end_token - 1].kind)) --end_token;
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
    if (degrees_begin()) {
      left = parse_degrees(left);
      continue;
    }
    const TokenRole role = role_of(kind());
    if (is_positive_part(left)) {
      left = parse_positive_part(left);
    } else if (is_transposed(left)) {
      left = parse_transposition(left);
    } else if (role.infix != 0) {
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

/// `(x)^+`, `[x]^{+}` or `(x)_+`, which clamp from below. A bare `x^+2` is a power with a sign.
bool Parser::is_positive_part(const Part& left) const {
  if (!at(TokenKind::Caret) && !at(TokenKind::Underscore)) return false;
  const uint32_t behind = behind_plus(position_);
  if (behind == position_) return false;
  const bool is_braced = kind_at(position_ + 1) == TokenKind::OpenBrace;
  if (at(TokenKind::Caret) && is_braced) return true;
  const NodeKind operand = block_.tree.node(left.node).kind;
  const bool is_bracketed = operand == NodeKind::Group || operand == NodeKind::Bars || operand == NodeKind::Angles;
  const TokenKind next = kind_at(behind);
  if (is_bracketed) return next != TokenKind::Number;
  return at(TokenKind::Caret) && !role_of(next).begins_operand && role_of(next).prefix == 0;
}

Parser::Part Parser::parse_positive_part(const Part& left) {
  const uint32_t sign = position_;
  continue_after(behind_plus(sign) - 1);
  recovering_ = false;
  return make(NodeKind::Angles, sign, first_token(left), {left});
}

/// `(a, b, c)^\top`, which is written for a column. A plain T may be a number, but not above a matrix. Of a column of
/// two or four a row is made.
bool Parser::is_transposed(const Part& left) const {
  const Node& node = block_.tree.node(left.node);
  if (!at(TokenKind::Caret) || node.kind != NodeKind::Tuple) return false;
  const uint32_t first_end = block_.tree.node(block_.tree.child(left.node, 0)).end_token;
  if (node.child_count != 3 && kind_behind(first_end - 1) == TokenKind::RowEnd) return false;
  const bool is_braced = kind_at(position_ + 1) == TokenKind::OpenBrace;
  const uint32_t sign = position_ + (is_braced ? 2 : 1);
  if (is_braced && kind_at(sign + 1) != TokenKind::CloseBrace) return false;
  const TokenKind kind = kind_at(sign);
  const std::string_view text = block_.token_text(sign);
  if (kind == TokenKind::Macro) return text == "\\top" || text == "\\intercal";
  const bool is_matrix = tokens_[node.token].kind == TokenKind::OpenMatrix;
  return is_matrix && ((kind == TokenKind::Word && text == "T") || (kind == TokenKind::Text && text.ends_with("T}")));
}

/// A tuple is a row as much as a column.
Parser::Part Parser::parse_transposition(const Part& left) {
  const uint32_t caret = position_;
  continue_after(kind_at(caret + 1) == TokenKind::OpenBrace ? caret + 3 : caret + 1);
  recovering_ = false;
  return make(NodeKind::Group, caret, first_token(left), {left});
}

/// `{} + a`: what TeX needs for its spaces.
void Parser::skip_empty_groups() {
  while (at(TokenKind::OpenBrace) && kind_at(position_ + 1) == TokenKind::CloseBrace &&
         role_of(kind_behind(position_ + 1)).infix != 0) {
    advance();
    advance();
  }
}

/// `^\circ`, `^{\circ}`, `°` or `\degree` behind an angle, `^o` behind a number.
bool Parser::degrees_begin() const {
  const auto is = [this](uint32_t token, std::string_view text) {
    return token < end_ && block_.token_text(token) == text;
  };
  if (!at(TokenKind::Caret)) return is(position_, "°") || is(position_, "\\degree");
  if (is(position_ + 1, "\\circ")) return true;
  const bool is_behind_number = position_ > 0 && tokens_[position_ - 1].kind == TokenKind::Number;
  if (is_behind_number && is(position_ + 1, "o")) return true;
  return is(position_ + 1, "{") && is(position_ + 2, "\\circ") && is(position_ + 3, "}");
}

Parser::Part Parser::parse_degrees(Part angle) {
  const uint32_t sign = position_;
  const bool is_raised = at(TokenKind::Caret);
  if (is_raised) advance();
  const bool is_in_braces = is_raised && at(TokenKind::OpenBrace);
  for (int rest = is_in_braces ? 3 : 1; rest > 0; --rest) advance();
  recovering_ = false;
  return make(NodeKind::Degrees, sign, first_token(angle), {angle});
}

/// A product without an operator.
Parser::Part Parser::parse_factor_behind(Part left) {
  const uint32_t second = position_;
  if (at(TokenKind::Number) && kind_before(second) == TokenKind::Number) report_number_behind_number(left);
  report_row_without_operator();
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
    case TokenKind::BigOperator:
      return parse_big_operator();
    case TokenKind::Integral:
    case TokenKind::OpenIntegral:
      return parse_integral();
    case TokenKind::DifferentialFactor:
      return parse_differential_factor();
    case TokenKind::DerivativeFrac:
      return parse_derivative();
    case TokenKind::OpenBrace:
      return decorated_group_begins() ? parse_name_or_call() : parse_group();
    case TokenKind::OpenParen:
    case TokenKind::OpenBracket:
    case TokenKind::OpenSet:
      return parse_group();
    case TokenKind::OpenAngle:
      return angled_name_begins() ? parse_call(parse_angled_name()) : parse_angles();
    case TokenKind::OpenCases:
      return parse_cases();
    case TokenKind::OpenMatrix:
      return parse_matrix();
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
    case TokenKind::CloseCases:
    case TokenKind::CloseMatrix:
    case TokenKind::OpenInterval:
    case TokenKind::CloseInterval:
    case TokenKind::CellEnd:
    case TokenKind::RowEnd:
    case TokenKind::Remark:
    case TokenKind::And:
    case TokenKind::Or:
    case TokenKind::Not:
    case TokenKind::Over:
    case TokenKind::Differential:
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
