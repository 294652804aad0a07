#include "syntax/parser.h"

namespace texbrdf {
namespace {

bool is_subscript_token(TokenKind kind) {
  switch (kind) {
    case TokenKind::Number:
    case TokenKind::Word:
    case TokenKind::Macro:
    case TokenKind::Text:
    case TokenKind::Function:
    case TokenKind::Extremum:
    case TokenKind::Plus:
    case TokenKind::Minus:
    case TokenKind::Multiply:
    case TokenKind::Cross:
      return true;
    case TokenKind::Vec:
    case TokenKind::Frac:
    case TokenKind::Sqrt:
    case TokenKind::Divide:
    case TokenKind::Caret:
    case TokenKind::Underscore:
    case TokenKind::Equals:
    case TokenKind::Comma:
    case TokenKind::OpenParen:
    case TokenKind::CloseParen:
    case TokenKind::OpenBrace:
    case TokenKind::CloseBrace:
    case TokenKind::OpenBracket:
    case TokenKind::CloseBracket:
    case TokenKind::OpenSet:
    case TokenKind::CloseSet:
    case TokenKind::Relation:
    case TokenKind::Ampersand:
    case TokenKind::Gap:
    case TokenKind::NewRow:
    case TokenKind::Unknown:
    case TokenKind::End:
      return false;
  }
  return false;
}

bool is_plain_name(TokenKind kind) {
  return kind == TokenKind::Word || kind == TokenKind::Macro || kind == TokenKind::Text;
}

}  // namespace

Parser::Part Parser::parse_name_leaf() {
  const uint32_t first = position_;
  const bool readable = parse_name();
  uint32_t end = position_;
  while (end > first + 1 && is_layout(tokens_[end - 1].kind)) --end;
  return leaf(readable ? NodeKind::Name : NodeKind::Error, first, std::max(end, first + 1));
}

Parser::Part Parser::parse_name_or_call() {
  const uint32_t first = position_;
  const Part name = parse_name_leaf();
  if (!block_.opens_arguments(position_)) return name;
  const uint32_t opener = advance();
  list_.push_back(name);
  return parse_list(NodeKind::Apply, opener, first, opener);
}

bool Parser::parse_name() {
  const bool base = parse_name_base();
  return parse_subscripts() && base;
}

bool Parser::parse_name_base() {
  if (at(TokenKind::Vec)) return parse_vec_name();
  const uint32_t token = position_;
  if (at(TokenKind::Text)) {
    const std::string_view text = block_.token_text(token);
    const size_t open = text.find('{');
    if (text.find_first_not_of(" \t\r\n", open + 1) == text.size() - 1) {
      report(Code::EmptyText, token, {std::string(text.substr(0, open))});
      advance();
      return false;
    }
  }
  advance();
  return true;
}

/// `\vec{name}`, or `\vec` and one token as TeX reads it.
bool Parser::parse_vec_name() {
  const uint32_t vec = advance();
  if (is_plain_name(kind())) return parse_name_base();
  if (!at(TokenKind::OpenBrace)) {
    report(Code::MissingGroup, position_, {"{", shown(vec, vec + 1), describe(position_)});
    return false;
  }
  const uint32_t opener = advance();
  bool readable = false;
  if (depth_ >= kMaxTreeHeight) {
    report_too_deep(position_);
  } else if (is_plain_name(kind()) || at(TokenKind::Vec)) {
    ++depth_;
    readable = parse_name();
    --depth_;
  } else {
    report_expected(Code::ExpectedName);
  }
  return close(opener) && readable;
}

bool Parser::parse_subscripts() {
  if (!at(TokenKind::Underscore)) return true;
  bool readable = parse_subscript();
  while (at(TokenKind::Underscore)) {
    report(Code::DoubleSubscript, position_);
    parse_subscript();
    readable = false;
  }
  return readable;
}

/// `_` and one token, a decorated name, or a brace group.
bool Parser::parse_subscript() {
  advance();
  if (at(TokenKind::OpenBrace)) return parse_subscript_group();
  if (at(TokenKind::Vec)) return parse_vec_name();
  if (is_subscript_token(kind())) return parse_name_base();
  if (at(TokenKind::Unknown)) {
    report_unknown();
    advance();
    return false;
  }
  report_expected(Code::MissingSubscript);
  return false;
}

/// Anything in balanced braces. Only subscripts in it have a structure.
bool Parser::parse_subscript_group() {
  const uint32_t opener = advance();
  if (depth_ >= kMaxTreeHeight) {
    report_too_deep(position_);
    return false;
  }
  bool readable = true;
  if (at(TokenKind::CloseBrace)) {
    report_expected(Code::MissingSubscript);
    readable = false;
  }
  ++depth_;
  for (bool has_base = false; !at(TokenKind::CloseBrace) && !at(TokenKind::End); has_base = true) {
    if (at(TokenKind::Underscore)) {
      if (!has_base) report_expected(Code::ExpectedName);
      readable = parse_subscripts() && readable && has_base;
    } else if (at(TokenKind::OpenBrace)) {
      readable = parse_subscript_group() && readable;
    } else {
      if (at(TokenKind::Unknown)) report_unknown();
      readable = readable && !at(TokenKind::Unknown);
      advance();
    }
  }
  --depth_;
  return close(opener) && readable;
}

/// `\vec{` followed by a digit, `.` or a sign.
bool Parser::vector_literal_begins() const {
  if (kind_behind(position_) != TokenKind::OpenBrace) return false;
  uint32_t token = position_;
  for (int steps = 0; steps < 2; ++steps) {
    do ++token;
    while (is_layout(tokens_[token].kind));
  }
  const TokenKind first = tokens_[token].kind;
  return first == TokenKind::Number || first == TokenKind::Plus || first == TokenKind::Minus ||
         (first == TokenKind::Unknown && block_.token_text(token) == ".");
}

}  // namespace texbrdf
