#include <utility>

#include "syntax/control_words.h"
#include "syntax/operators.h"
#include "syntax/parser.h"

namespace texbrdf {
namespace {

/// `-1`, as it stands above a function for its inverse.
bool is_minus_one(const ParsedBlock& block, NodeId exponent) {
  const SyntaxTree& tree = block.tree;
  while (tree.node(exponent).kind == NodeKind::Group) exponent = tree.child(exponent, 0);
  if (tree.node(exponent).kind != NodeKind::Prefix) return false;
  return block.tokens[tree.node(exponent).token].kind == TokenKind::Minus &&
         block.node_text(tree.child(exponent, 0)) == "1";
}

}  // namespace

/// What a bracket holds: an expression, or `a \over b`. `bar`: what closes it, where that is a bar.
Parser::Part Parser::parse_inside(TokenKind bar) {
  const TokenKind open_bar = std::exchange(open_bar_, bar);
  const uint32_t first = position_;
  Part inner = in_condition_ ? parse_condition(ConditionPlace::Brackets) : parse_expression(0);
  if (at(TokenKind::Over)) {
    const uint32_t over = advance();
    recovering_ = false;
    const Part denominator = parse_expression(0);
    inner = make(NodeKind::Fraction, over, first, {inner, denominator});
  }
  open_bar_ = open_bar;
  return inner;
}

Parser::Part Parser::parse_group() {
  const uint32_t opener = advance();
  const Part inner = parse_inside();
  if (at(TokenKind::Comma) && tokens_[opener].kind != TokenKind::OpenBrace) {
    list_.push_back(inner);
    return finish_list(NodeKind::Tuple, opener, opener, opener, list_.size() - 1);
  }
  const bool closed = close(opener);
  return make(closed ? NodeKind::Group : NodeKind::Error, opener, opener, {inner});
}

/// What the bar says itself: `\\left|` and `\\lvert` open, `\\right|` and `\\rvert` close.
Parser::BarSide Parser::bar_side(uint32_t bar) const {
  const std::string_view text = block_.token_text(bar);
  const uint32_t behind = bar == 0 ? block_.extent.content.begin : tokens_[bar - 1].span.end;
  std::string_view before = block_.slice({behind, tokens_[bar].span.begin});
  const size_t backslash = before.rfind('\\');
  before = backslash == std::string_view::npos ? "" : before.substr(backslash + 1);
  if (text.starts_with("\\l") || before == "left" || (before.starts_with("big") && before.ends_with('l')) ||
      (before.starts_with("Big") && before.ends_with('l'))) {
    return BarSide::Left;
  }
  if (text.starts_with("\\r") || before == "right" || (before.starts_with("big") && before.ends_with('r')) ||
      (before.starts_with("Big") && before.ends_with('r'))) {
    return BarSide::Right;
  }
  return BarSide::Either;
}

/// A bar that does not say it opens where an operator could stand, unless it closes the one that is open.
bool Parser::opens_bars() const {
  if (!at(TokenKind::Bar) && !at(TokenKind::DoubleBar)) return false;
  const BarSide side = bar_side(position_);
  return side == BarSide::Left || (side == BarSide::Either && kind() != open_bar_);
}

bool Parser::is_doubled_bar(uint32_t first, uint32_t second) const {
  return kind_at(first) == TokenKind::Bar && kind_at(second) == TokenKind::Bar &&
         tokens_[first].span.end == tokens_[second].span.begin && bar_side(first) == BarSide::Either &&
         bar_side(second) == BarSide::Either;
}

/// `|x|`, `\|x\|`, and `||x||`, which is written so by many.
Parser::Part Parser::parse_bars() {
  if (!opens_bars()) {
    report_expected(Code::NoExpression);
    return error_here();
  }
  const TokenKind bar = kind();
  const uint32_t opener = advance();
  const bool is_doubled = is_doubled_bar(opener, position_);
  if (is_doubled) advance();
  const Part inner = parse_inside(bar);
  bool closed = true;
  for (int closers = is_doubled ? 2 : 1; closers > 0 && closed; --closers) {
    closed = at(bar);
    if (closed) advance();
  }
  if (closed) {
    recovering_ = false;
    return make(NodeKind::Bars, opener, opener, {inner});
  }
  report(Code::UnclosedBracket, opener, {std::string(block_.token_text(opener))});
  return make(NodeKind::Error, opener, opener, {inner});
}

Parser::Part Parser::parse_angles() {
  const uint32_t opener = advance();
  const Part list = parse_list(NodeKind::Angles, opener, opener, opener);
  constexpr uint32_t kMost = 2;
  if (list.damaged || block_.tree.node(list.node).child_count <= kMost) return list;
  report(Code::UnexpectedToken, opener, {"a list of more than two in angle brackets"});
  return make(NodeKind::Error, opener, opener, {list});
}

/// Reads the closer of the opener. Where something else stands, all up to the closer is skipped.
bool Parser::close(uint32_t opener) {
  if (kind() == closer_of(tokens_[opener].kind)) {
    advance();
    recovering_ = false;
    return true;
  }
  report_expected(Code::UnexpectedToken);
  if (brackets_are_broken_) {
    const uint32_t partner = faults_.partner_of(opener);
    if (partner == UINT32_MAX || partner < position_) return false;
    continue_after(partner);
    return false;
  }
  uint32_t open = 1;
  for (uint32_t i = position_; i < end_; ++i) {
    if (is_opener(tokens_[i].kind)) ++open;
    if (is_closer(tokens_[i].kind) && --open == 0) {
      continue_after(i);
      break;
    }
  }
  return false;
}

/// `\cos x`, `\cos^2 x`, `\cos^{-1} x`, `\log_2 x`.
Parser::Part Parser::parse_function() {
  const uint32_t command = advance();
  report_bare_function(command);
  const bool has_base = at(TokenKind::Underscore) && takes_base(tokens_[command].command);
  Part base;
  if (has_base) {
    const uint32_t underscore = advance();
    base = parse_braced(underscore);
  }
  const uint32_t caret = position_;
  const bool has_power = at(TokenKind::Caret);
  Part exponent;
  if (has_power) exponent = parse_function_power();
  const bool is_inverse = has_power && !exponent.damaged && is_minus_one(block_, exponent.node);
  if (is_inverse && (has_base || inverse_of(tokens_[command].command) == Command::None))
    report_no_inverse(command, caret);

  FunctionOperand read;
  const Part operand = parse_function_operand(false, read);
  const NodeKind function_kind = is_inverse ? NodeKind::Inverse : NodeKind::Function;
  const Part function = has_base ? make(function_kind, command, command, {operand, base})
                                 : make(function_kind, command, command, {operand});
  if (!function.damaged) report_reading(function, read);
  if (!has_power || is_inverse) return function;
  return make(NodeKind::Infix, caret, command, {function, exponent});
}

/// A number, a name or a brace group: `(` behind a name opens the function's operand.
Parser::Part Parser::parse_function_power() {
  advance();
  recovering_ = false;
  if (at(TokenKind::OpenBrace)) return parse_group();
  if (at(TokenKind::Word) || at(TokenKind::Macro) || at(TokenKind::Text)) return parse_name_leaf();
  if (at(TokenKind::Number)) return parse_primary();
  report_expected(Code::NoExpression);
  return error_here();
}

/// Factors side by side, the first perhaps behind signs; or what stands in brackets. What is not in brackets takes its
/// power with it.
Parser::Part Parser::parse_function_operand(bool behind_sign, FunctionOperand& read) {
  if (depth_ >= kMaxTreeHeight) {
    report_too_deep(position_);
    return error_here();
  }
  ++depth_;
  Part operand;
  if (role_of(kind()).prefix != 0) {
    const uint32_t sign = advance();
    operand = parse_function_operand(true, read);
    operand = make(NodeKind::Prefix, sign, sign, {operand});
  } else {
    operand = parse_first_factor(behind_sign, read);
  }
  --depth_;
  return operand;
}

Parser::Part Parser::parse_first_factor(bool behind_sign, FunctionOperand& read) {
  const bool in_brackets = is_opener(kind());
  Part operand = parse_primary();
  if (in_brackets && !behind_sign) return operand;
  if (degrees_begin()) return parse_degrees(operand);
  if (at(TokenKind::Caret)) {
    read.power = advance();
    recovering_ = false;
    const Part exponent = parse_expression(kPowerOperatorPower);
    operand = make(NodeKind::Infix, read.power, first_token(operand), {operand, exponent});
    report_power_chain(operand);
  }
  if (in_brackets) return operand;
  while (continues_function_operand() && !silent_) {
    if (read.factor == kNone) read.factor = position_;
    const uint32_t factor = position_;
    const Part right = parse_expression(kPowerOperatorPower);
    const bool damage = operand.damaged || right.damaged;
    operand = make(damage ? NodeKind::Error : NodeKind::Juxtaposition, factor, first_token(operand), {operand, right});
  }
  return operand;
}

/// A name straight behind, as in `\cos n\phi`; a space command between them ends the operand.
bool Parser::continues_function_operand() const {
  if (!at(TokenKind::Word) && !at(TokenKind::Macro) && !at(TokenKind::Text) && !at(TokenKind::Vec) &&
      !at(TokenKind::Accent)) {
    return false;
  }
  if (is_layout(tokens_[position_ - 1].kind)) return false;
  const Span gap = {tokens_[position_ - 1].span.end, tokens_[position_].span.begin};
  return block_.slice(gap).find('\\') == std::string_view::npos;
}

Parser::Part Parser::parse_extremum() {
  const uint32_t command = advance();
  report_bare_function(command);
  if (!is_opener(kind())) {
    report(Code::MissingGroup, position_, {"(", shown(command, command + 1), describe(position_)});
    return make(NodeKind::Error, command, command, {});
  }
  const uint32_t opener = advance();
  return parse_list(NodeKind::Extremum, command, command, opener);
}

/// Expressions with commas between them, up to the opener's closer. Parts that the caller has put on `list_` behind
/// `first_element` come first.
Parser::Part Parser::parse_list(NodeKind kind, uint32_t token, uint32_t first_token, uint32_t opener) {
  const size_t first_element = kind == NodeKind::Apply ? list_.size() - 1 : list_.size();
  list_.push_back(parse_inside());
  return finish_list(kind, token, first_token, opener, first_element);
}

/// What follows the first expression of a list.
Parser::Part Parser::finish_list(NodeKind kind, uint32_t token, uint32_t first_token, uint32_t opener,
                                 size_t first_element) {
  while (at(TokenKind::Comma)) {
    advance();
    recovering_ = false;
    list_.push_back(parse_inside());
  }
  const bool closed = close(opener);
  const Part list = make(closed ? kind : NodeKind::Error, token, first_token, list_.data() + first_element,
                         list_.size() - first_element);
  list_.resize(first_element);
  return list;
}

Parser::Part Parser::parse_fraction() {
  const uint32_t command = advance();
  const Part numerator = parse_braced(command);
  if (numerator.damaged && !role_of(kind()).begins_operand) {
    return make(NodeKind::Error, command, command, {numerator});
  }
  const Part denominator = parse_braced(command);
  return make(NodeKind::Fraction, command, command, {numerator, denominator});
}

/// The expression of a brace group, without the group: the braces belong to the command. Else one symbol, as TeX reads
/// `\frac\rho\pi`.
Parser::Part Parser::parse_braced(uint32_t owner) {
  if (at(TokenKind::Number)) return parse_primary();
  if (at(TokenKind::Macro) || at(TokenKind::Text) || at(TokenKind::Vec) || at(TokenKind::Accent) || at_one_letter()) {
    return parse_bare_name();
  }
  if (!at(TokenKind::OpenBrace)) {
    report(Code::MissingGroup, position_, {"{", shown(owner, owner + 1), describe(position_)});
    return error_here();
  }
  const uint32_t opener = advance();
  const Part inner = parse_inside();
  if (close(opener)) return inner;
  return make(NodeKind::Error, opener, opener, {inner});
}

Parser::Part Parser::parse_root() {
  const uint32_t command = advance();
  Part index;
  const bool has_index = at(TokenKind::OpenBracket);
  if (has_index) {
    const uint32_t opener = advance();
    index = parse_inside();
    if (!close(opener)) index = make(NodeKind::Error, opener, opener, {index});
  }
  const bool has_sign = role_of(kind()).prefix != 0;
  if (depth_ >= kMaxTreeHeight) {
    report_too_deep(position_);
    return error_here();
  }
  ++depth_;
  Part radicand;
  if (has_sign) {
    const uint32_t sign = advance();
    radicand = make(NodeKind::Prefix, sign, sign, {parse_primary()});
  } else {
    radicand = parse_primary();
  }
  --depth_;
  if (has_index) return make(NodeKind::Root, command, command, {radicand, index});
  return make(NodeKind::Root, command, command, {radicand});
}

Parser::Part Parser::parse_vector_literal() {
  const uint32_t vec = advance();
  const uint32_t opener = advance();
  Part vector = parse_list(NodeKind::VectorLiteral, vec, vec, opener);
  bool damaged = vector.damaged;
  if (!damaged) check_vector_elements(vector, damaged);
  if (!damaged || vector.damaged) return vector;
  return make(NodeKind::Error, vec, vec, {vector});
}

}  // namespace texbrdf
