#include "syntax/open_environments.h"

#include "syntax/brackets.h"
#include "syntax/relations.h"
#include "syntax/remark.h"

namespace texbrdf {

using Role = MathEnvironment::Role;

TokenKind OpenEnvironments::Entry::opener() const {
  return role == Role::Cases ? TokenKind::OpenCases : TokenKind::OpenMatrix;
}

TokenKind OpenEnvironments::Entry::closer() const {
  return closer_of(opener());
}

void OpenEnvironments::open(const MathEnvironment& environment, bool is_behind_brace) {
  Entry& entry = open_.emplace_back();
  entry.environment = &environment;
  entry.role = is_behind_brace ? Role::Cases : environment.role;
  entry.is_behind_brace = is_behind_brace;
  ++count_of(environment);
  if (entry.is_operand()) ++operands_;
}

std::optional<OpenEnvironments::Entry> OpenEnvironments::close(const MathEnvironment* environment) {
  const bool is_open = environment != nullptr && count_of(*environment) > 0;
  if (!is_open && operands_ == 0) return std::nullopt;
  while (is_open ? open_.back().environment != environment : !open_.back().is_operand()) pop();
  const Entry closed = open_.back();
  pop();
  return closed;
}

void OpenEnvironments::pop() {
  --count_of(*open_.back().environment);
  if (open_.back().is_operand()) --operands_;
  open_.pop_back();
}

uint32_t& OpenEnvironments::count_of(const MathEnvironment& environment) {
  return counts_.at(static_cast<size_t>(&environment - math_environments().data()));
}

TokenKind OpenEnvironments::kind_in_rows(TokenKind kind, std::string_view text, TokenKind before,
                                         std::string_view text_before) {
  if (kind == TokenKind::NewRow) return TokenKind::RowEnd;
  if (text == "&") return TokenKind::CellEnd;
  kind = kind_of_bracket(kind, before, text_before);
  return open_.back().role == Role::Cases ? kind_in_case(open_.back(), kind, text, before) : kind;
}

/// `(0, 1]` behind `\in` is an interval: its brackets need not be of one kind.
TokenKind OpenEnvironments::kind_of_bracket(TokenKind kind, TokenKind before, std::string_view text_before) {
  Entry& rows = open_.back();
  const bool may_open = kind == TokenKind::OpenBracket || kind == TokenKind::OpenParen;
  const bool may_close = kind == TokenKind::CloseBracket || kind == TokenKind::CloseParen;
  if (may_open && !rows.interval && before == TokenKind::Relation && read_relation(text_before) == Relation::Member) {
    rows.interval = rows.brackets;
    kind = TokenKind::OpenInterval;
  } else if (may_close && rows.interval && *rows.interval + 1 == rows.brackets) {
    rows.interval.reset();
    kind = TokenKind::CloseInterval;
  }
  if (is_opener(kind)) ++rows.brackets;
  if (is_closer(kind) && rows.brackets > 0) --rows.brackets;
  if (kind == TokenKind::OpenBrace) ++rows.braces;
  if (kind == TokenKind::CloseBrace && rows.braces > 0) --rows.braces;
  return kind;
}

TokenKind OpenEnvironments::kind_in_case(const Entry& rows, TokenKind kind, std::string_view text, TokenKind before) {
  if (rows.brackets > 0) return kind;
  if (kind == TokenKind::Gap) return TokenKind::CellEnd;
  if (kind == TokenKind::Unknown && (text == "." || text == ":")) return TokenKind::CellEnd;
  const bool is_part_of_name = before == TokenKind::Underscore || before == TokenKind::Caret ||
                               before == TokenKind::Vec || before == TokenKind::Accent;
  return kind == TokenKind::Word && !is_part_of_name && is_bare_remark(text) ? TokenKind::Remark : kind;
}

}  // namespace texbrdf
