#include <algorithm>

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
    case TokenKind::Accent:
    case TokenKind::Prime:
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
    case TokenKind::OpenAngle:
    case TokenKind::CloseAngle:
    case TokenKind::Bar:
    case TokenKind::DoubleBar:
    case TokenKind::Over:
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

bool is_decoration(TokenKind kind) {
  return kind == TokenKind::Vec || kind == TokenKind::Accent;
}

}  // namespace

Parser::Part Parser::parse_name_leaf() {
  const uint32_t first = position_;
  return name_leaf(first, parse_name());
}

/// Without subscripts.
Parser::Part Parser::parse_bare_name() {
  const uint32_t first = position_;
  return name_leaf(first, parse_name_base());
}

Parser::Part Parser::name_leaf(uint32_t first, bool readable) {
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
  parse_primes();
  const bool subscripts = parse_subscripts();
  parse_primes();
  return subscripts && base;
}

bool Parser::parse_name_base() {
  if (is_decoration(kind())) return parse_decorated_name();
  if (at(TokenKind::OpenBrace)) return parse_decorated_group();
  const uint32_t token = position_;
  if (at(TokenKind::Text)) {
    const std::string_view text = block_.token_text(token);
    const size_t open = text.find('{');
    if (open != std::string_view::npos && text.find_first_not_of(" \t\r\n", open + 1) == text.size() - 1) {
      report(Code::EmptyText, token, {std::string(text.substr(0, open))});
      advance();
      return false;
    }
  }
  advance();
  return true;
}

/// `\vec{name}`, or `\vec` and one token as TeX reads it; also `\hat\mathbf{n}`.
bool Parser::parse_decorated_name() {
  const uint32_t decoration = advance();
  if (is_plain_name(kind())) return parse_name_base();
  if (at(TokenKind::OpenBrace)) return parse_decorated_group();
  if (depth_ >= kMaxTreeHeight) {
    report_too_deep(position_);
    return false;
  }
  if (!is_decoration(kind())) {
    report(Code::MissingGroup, position_, {"{", shown(decoration, decoration + 1), describe(position_)});
    return false;
  }
  ++depth_;
  const bool readable = parse_decorated_name();
  --depth_;
  return readable;
}

/// The name in the braces behind a decoration, or of `{\bf n}`.
bool Parser::parse_decorated_group() {
  const uint32_t opener = advance();
  bool readable = false;
  if (depth_ >= kMaxTreeHeight) {
    report_too_deep(position_);
  } else if (is_plain_name(kind()) || is_decoration(kind()) || at(TokenKind::OpenBrace)) {
    ++depth_;
    readable = parse_name();
    --depth_;
  } else {
    report_expected(Code::ExpectedName);
  }
  return close(opener) && readable;
}

void Parser::parse_primes() {
  while (primes_begin()) {
    if (at(TokenKind::Caret)) advance();
    const bool in_braces = at(TokenKind::OpenBrace);
    do advance();
    while (at(TokenKind::Prime));
    if (in_braces) advance();
  }
}

/// `'`, `^\prime` or `^{\prime\prime}`.
bool Parser::primes_begin() const {
  if (at(TokenKind::Prime)) return true;
  if (!at(TokenKind::Caret)) return false;
  uint32_t token = position_ + 1;
  if (tokens_[token].kind != TokenKind::OpenBrace) return tokens_[token].kind == TokenKind::Prime;
  do ++token;
  while (tokens_[token].kind == TokenKind::Prime);
  return token > position_ + 2 && tokens_[token].kind == TokenKind::CloseBrace;
}

/// `{\bf n}`, `{\mathbf{n}}` or `{\hat n_i}`: braces around one decorated name and nothing else. Around a `\vec` they
/// only group, and in the place of an exponent they are those of the power.
bool Parser::decorated_group_begins() const {
  if (position_ > 0 && tokens_[position_ - 1].kind == TokenKind::Caret) return false;
  constexpr uint32_t kLongest = 32;
  const uint32_t end = std::min(position_ + kLongest, end_);
  uint32_t token = position_ + 1;
  if (!is_decoration(tokens_[token].kind) || block_.slice(tokens_[token].span) == "\\vec") return false;
  uint32_t open = 1;
  for (; token < end && (is_decoration(tokens_[token].kind) || tokens_[token].kind == TokenKind::OpenBrace); ++token) {
    if (tokens_[token].kind == TokenKind::OpenBrace) ++open;
  }
  if (token >= end || !is_plain_name(tokens_[token].kind)) return false;
  uint32_t in_subscript = 0;
  for (++token; token < end; ++token) {
    const TokenKind here = tokens_[token].kind;
    const bool is_subscript = tokens_[token - 1].kind == TokenKind::Underscore;
    if (here == TokenKind::OpenBrace && (is_subscript || in_subscript > 0)) {
      ++in_subscript;
    } else if (here == TokenKind::CloseBrace && in_subscript > 0) {
      --in_subscript;
    } else if (here == TokenKind::CloseBrace) {
      if (--open == 0) return true;
    } else if (in_subscript == 0 && !is_subscript && here != TokenKind::Underscore && here != TokenKind::Prime) {
      return false;
    }
  }
  return false;
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
  if (is_decoration(kind())) return parse_decorated_name();
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
  if (block_.slice(tokens_[position_].span) != "\\vec") return false;
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
