#include <algorithm>
#include <array>

#include "syntax/parser.h"

namespace texbrdf {
namespace {

constexpr auto kSubscripts = std::to_array<TokenKind>(
    {TokenKind::Number, TokenKind::Word, TokenKind::Macro, TokenKind::Text, TokenKind::Function, TokenKind::Extremum,
     TokenKind::Plus, TokenKind::Minus, TokenKind::Multiply, TokenKind::Cross});

bool is_subscript_token(TokenKind kind) {
  return std::ranges::find(kSubscripts, kind) != kSubscripts.end();
}

bool is_plain_name(TokenKind kind) {
  return kind == TokenKind::Word || kind == TokenKind::Macro || kind == TokenKind::Text;
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
  while (end > first + 1 && means_nothing_at_end(tokens_[end - 1].kind)) --end;
  return leaf(readable ? NodeKind::Name : NodeKind::Error, first, std::max(end, first + 1));
}

Parser::Part Parser::parse_name_or_call() {
  return parse_call(parse_name_leaf());
}

/// The arguments behind the name, if there are some.
Parser::Part Parser::parse_call(const Part& name) {
  if (block_.is_power_of_call(position_)) return parse_power_of_call(name);
  if (!block_.opens_arguments(position_)) return name;
  const uint32_t opener = advance();
  list_.push_back(name);
  return parse_list(NodeKind::Apply, opener, first_token(name), opener);
}

/// `\langle E\rangle`
Parser::Part Parser::parse_angled_name() {
  const uint32_t opener = advance();
  const bool readable = parse_name();
  const bool closed = close(opener);
  return name_leaf(opener, readable && closed);
}

/// `a^2(x)`, the square of a call.
Parser::Part Parser::parse_power_of_call(const Part& name) {
  const uint32_t caret = position_;
  const Part exponent = parse_function_power();
  if (!at(TokenKind::OpenParen)) return make(NodeKind::Infix, caret, first_token(name), {name, exponent});
  const uint32_t opener = advance();
  list_.push_back(name);
  const Part call = parse_list(NodeKind::Apply, opener, first_token(name), opener);
  return make(NodeKind::Infix, caret, first_token(name), {call, exponent});
}

bool Parser::parse_name() {
  const uint32_t first = position_;
  const bool base = parse_name_base();
  parse_primes();
  const bool subscripts = parse_subscripts();
  parse_primes();
  parse_label();
  parse_plus(first);
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

/// `^{(1)}` in front of arguments: part of the name, as papers number the terms of a series.
void Parser::parse_label() {
  constexpr uint32_t kLength = 5;
  if (position_ + kLength >= end_) return;
  const auto is = [this](uint32_t behind, TokenKind kind) { return tokens_[position_ + behind].kind == kind; };
  const bool has_content = is(3, TokenKind::Number) || is(3, TokenKind::Word) || is(3, TokenKind::Text);
  const bool is_label = has_content && is(0, TokenKind::Caret) && is(1, TokenKind::OpenBrace) &&
                        is(2, TokenKind::OpenParen) && is(4, TokenKind::CloseParen) && is(5, TokenKind::CloseBrace);
  if (!is_label || kind_behind(position_ + kLength) != TokenKind::OpenParen) return;
  continue_after(position_ + kLength);
}

/// Behind `^+` or `^{+}`, also with `_`; the caret itself where no plus stands above it.
uint32_t Parser::behind_plus(uint32_t caret) const {
  if (kind_at(caret + 1) == TokenKind::Plus) return caret + 2;
  const bool is_braced = kind_at(caret + 1) == TokenKind::OpenBrace && kind_at(caret + 2) == TokenKind::Plus &&
                         kind_at(caret + 3) == TokenKind::CloseBrace;
  return is_braced ? caret + 4 : caret;
}

/// The plus of `\chi^+`, the step function, belongs to its name.
void Parser::parse_plus(uint32_t base) {
  if (!at(TokenKind::Caret) || position_ != base + 1 || block_.token_text(base) != "\\chi") return;
  const uint32_t behind = behind_plus(position_);
  if (behind != position_) continue_after(behind - 1);
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
