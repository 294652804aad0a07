#include <algorithm>
#include <utility>

#include "syntax/math_regions.h"
#include "syntax/operators.h"
#include "syntax/parser.h"
#include "syntax/relations.h"

namespace texbrdf {
namespace {

/// More would be a tree of choices too high to walk.
constexpr size_t kMaxRows = 200;

/// Its rows begin with a `&`, where they are aligned.
bool is_alignment(std::string_view begin) {
  const MathEnvironment* const environment = find_math_environment(environment_name(begin));
  return environment != nullptr && !environment->is_operand();
}

}  // namespace

/// `\begin{cases} value & condition \\ … \end{cases}`
Parser::Part Parser::parse_cases() {
  ++open_rows_;
  const uint32_t opener = advance();
  const TokenKind open_bar = std::exchange(open_bar_, TokenKind::End);
  const bool in_condition = std::exchange(in_condition_, false);
  const bool is_aligned = is_alignment(block_.token_text(opener));
  std::vector<CaseRow> rows;
  for (;;) {
    if (is_aligned && at(TokenKind::CellEnd)) advance();
    if (!row_ends()) rows.push_back(parse_case());
    if (!at(TokenKind::RowEnd)) break;
    advance();
    recovering_ = false;
  }
  open_bar_ = open_bar;
  in_condition_ = in_condition;
  if (rows.empty()) {
    report_expected(Code::NoExpression);
    rows.push_back({.part = error_here()});
  }
  const bool closed = close_environment(opener);
  if (rows.size() > kMaxRows) report_too_deep(opener);
  check_rows(opener, rows);
  const bool is_readable = closed && rows.size() <= kMaxRows;
  std::vector<Part> parts;
  for (const CaseRow& row : rows) parts.push_back(row.part);
  return make(is_readable ? NodeKind::Cases : NodeKind::Error, opener, opener, parts.data(), parts.size());
}

/// Its value, what stands between, its condition and punctuation behind.
Parser::CaseRow Parser::parse_case() {
  const uint32_t first = position_;
  const Part value = parse_expression(0);
  if (!at(TokenKind::CellEnd) && !at(TokenKind::Comma) && !at(TokenKind::Remark) && !row_ends()) {
    report_expected(Code::UnexpectedToken);
    skip_to_row_end();
    return {.part = make(NodeKind::Error, first, first, {value})};
  }
  recovering_ = false;
  const bool is_rest = skip_to_condition();
  if (is_rest) skip_to_row_end();
  if (row_ends()) return {.part = make(NodeKind::Case, first, first, {value}), .is_rest = is_rest};

  in_condition_ = true;
  const Part condition = parse_condition(ConditionPlace::Cell);
  in_condition_ = false;
  skip_to_condition();
  const bool is_read = row_ends();
  if (!is_read) {
    report_expected(Code::UnexpectedToken);
    skip_to_row_end();
  }
  return {.part = make(is_read ? NodeKind::Case : NodeKind::Error, first, first, {value, condition})};
}

/// `, & \text{if}`; true where it says that no condition follows.
bool Parser::skip_to_condition() {
  for (;;) {
    if (at(TokenKind::Remark)) {
      const RemarkKind remark = remark_at(position_);
      if (remark == RemarkKind::Otherwise) return true;
      if (remark != RemarkKind::Introduction && remark != RemarkKind::Nothing) return false;
    } else if (!at(TokenKind::CellEnd) && !at(TokenKind::Comma)) {
      return false;
    }
    advance();
  }
}

void Parser::skip_to_row_end() {
  uint32_t open = 0;
  uint32_t token = position_;
  for (; token < end_; ++token) {
    const TokenKind here = tokens_[token].kind;
    if (open == 0 && (here == TokenKind::RowEnd || is_closer(here))) break;
    if (is_opener(here)) ++open;
    if (is_closer(here)) --open;
  }
  position_ = token;
}

RemarkKind Parser::remark_at(uint32_t token) const {
  return kind_at(token) == TokenKind::Remark ? read_remark(block_.token_text(token)) : RemarkKind::Unknown;
}

/// Only one row may hold where no other does. Without one, the hint says what holds there.
void Parser::check_rows(uint32_t opener, std::span<const CaseRow> rows) {
  bool has_rest = false;
  for (size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].part.damaged) return;
    if (block_.tree.node(rows[i].part.node).child_count > 1) continue;
    const bool is_last = i + 1 == rows.size();
    if (has_rest || !(rows[i].is_rest || is_last)) {
      report(Code::RowWithoutCondition, first_token(rows[i].part), block_.span(rows[i].part.node), {});
      return;
    }
    has_rest = true;
  }
  if (has_rest || is_silent_at(opener) || is_exhaustive(rows)) return;
  block_.diagnostics.push_back(make_diagnostic(Code::CasesWithoutRest, at_span(tokens_[opener].span)));
}

/// The last condition is the opposite of another: `x > 0` and `x \le 0`.
bool Parser::is_exhaustive(std::span<const CaseRow> rows) const {
  struct Sides {
    std::string_view left, right;
    Relation relation = Relation::None;
    bool operator==(const Sides&) const = default;
  };
  const SyntaxTree& tree = block_.tree;
  const auto sides = [&](const CaseRow& row) -> Sides {
    const NodeId condition = tree.child(row.part.node, 1);
    if (tree.node(condition).kind != NodeKind::Comparison || tree.node(condition).child_count != 2) return {};
    return {block_.node_text(tree.child(condition, 0)), block_.node_text(tree.child(condition, 1)),
            read_relation(block_.token_text(tree.node(condition).token))};
  };
  const Sides last = sides(rows.back());
  if (last.relation == Relation::None) return false;
  const Sides rest = {last.left, last.right, opposite(last.relation)};
  const Sides rest_mirrored = {last.right, last.left, mirrored(rest.relation)};
  return std::ranges::any_of(rows, [&](const CaseRow& row) {
    const Sides other = sides(row);
    return other == rest || other == rest_mirrored;
  });
}

bool Parser::close_environment(uint32_t opener) {
  --open_rows_;
  const uint32_t closer = position_;
  if (!close(opener)) return false;
  const std::string_view begin = block_.token_text(opener);
  const std::string_view end = block_.token_text(closer);
  if (environment_name(begin) == environment_name(end)) return true;
  Diagnostic* const diagnostic = report(Code::WrongEnd, opener, {std::string(begin), std::string(end)});
  recovering_ = false;
  if (diagnostic == nullptr) return true;
  const std::string right_end = "\\end{" + std::string(environment_name(begin)) + "}";
  const Location where = at_span(tokens_[closer].span);
  diagnostic->related.push_back({where, "closed here"});
  diagnostic->fixes.push_back({"replace by `" + right_end + "`", {{where, right_end}}});
  return true;
}

/// One of several, of which each may be a conjunction.
Parser::Part Parser::parse_condition(ConditionPlace place) {
  Part left = parse_conjunction(place);
  while (joins(TokenKind::Or, place)) {
    const uint32_t junction = advance();
    recovering_ = false;
    const Part right = parse_conjunction(place);
    left = make(NodeKind::Junction, junction, first_token(left), {left, right});
  }
  return left;
}

Parser::Part Parser::parse_conjunction(ConditionPlace place) {
  Part left = parse_negation(place);
  while (joins(TokenKind::And, place)) {
    const uint32_t junction = advance();
    recovering_ = false;
    const Part right = parse_negation(place);
    left = make(NodeKind::Junction, junction, first_token(left), {left, right});
  }
  return left;
}

/// `\land`, `\text{and}`, or, outside of brackets, a comma with a condition behind it.
bool Parser::joins(TokenKind junction, ConditionPlace place) {
  if (place == ConditionPlace::Cell) {
    while (at(TokenKind::CellEnd)) advance();
  }
  const RemarkKind word = junction == TokenKind::And ? RemarkKind::And : RemarkKind::Or;
  if (at(junction) || remark_at(position_) == word) return true;
  if (place != ConditionPlace::Cell || !at(TokenKind::Comma)) return false;
  const TokenKind next = kind_behind(position_);
  if (next == TokenKind::Remark) {
    advance();
    return remark_at(position_) == word;
  }
  return junction == TokenKind::And && (role_of(next).begins_operand || role_of(next).prefix != 0);
}

Parser::Part Parser::parse_negation(ConditionPlace place) {
  while (place == ConditionPlace::Cell &&
         (at(TokenKind::CellEnd) || remark_at(position_) == RemarkKind::Introduction)) {
    advance();
  }
  if (!at(TokenKind::Not)) return parse_comparison();
  if (depth_ >= kMaxTreeHeight) {
    report_too_deep(position_);
    return error_here();
  }
  ++depth_;
  const uint32_t sign = advance();
  const Part operand = parse_negation(place);
  --depth_;
  return make(NodeKind::Not, sign, sign, {operand});
}

/// `x > 0`, `0 < x \le 1`; without a relation what stands in brackets may be a condition.
Parser::Part Parser::parse_comparison() {
  const Part left = parse_expression(0);
  if (!at_relation()) return left;
  const uint32_t first_relation = position_;
  if (read_relation(block_.token_text(first_relation)) == Relation::Member) return parse_membership(left);
  const size_t first_operand = list_.size();
  list_.push_back(left);
  while (at_relation()) {
    const Relation relation = read_relation(block_.token_text(position_));
    if (relation == Relation::None || relation == Relation::Member) {
      report(Code::NoComparison, position_, {std::string(block_.token_text(position_))});
    }
    advance();
    const bool damaged = recovering_;
    recovering_ = false;
    list_.push_back(parse_expression(0));
    recovering_ = recovering_ || damaged;
  }
  const Part comparison = make(NodeKind::Comparison, first_relation, first_token(left), list_.data() + first_operand,
                               list_.size() - first_operand);
  list_.resize(first_operand);
  return comparison;
}

/// `x \in [0, 1)`
Parser::Part Parser::parse_membership(const Part& left) {
  const uint32_t relation = advance();
  recovering_ = false;
  if (!at(TokenKind::OpenInterval)) {
    report(Code::NoComparison, relation, {std::string(block_.token_text(relation))});
    return make(NodeKind::Error, relation, first_token(left), {left});
  }
  const uint32_t opener = advance();
  const bool in_condition = std::exchange(in_condition_, false);
  const Part low = parse_inside();
  Part high = low;
  const bool has_comma = at(TokenKind::Comma);
  if (has_comma) {
    advance();
    high = parse_inside();
  }
  in_condition_ = in_condition;
  const bool closed = close(opener) && has_comma;
  if (!has_comma) {
    report(Code::NoComparison, relation, {std::string(block_.token_text(relation))});
    return make(NodeKind::Error, opener, first_token(left), {left, low});
  }
  return make(closed ? NodeKind::Membership : NodeKind::Error, opener, first_token(left), {left, low, high});
}

}  // namespace texbrdf
