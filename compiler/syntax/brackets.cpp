#include "syntax/brackets.h"

#include <algorithm>
#include <array>

namespace texbrdf {
namespace {

constexpr uint32_t kNone = UINT32_MAX;

/// One comparison for the kinds that follow each other in token_kind.def.
constexpr bool is_bracket(TokenKind kind) {
  return kind >= TokenKind::OpenParen && kind <= TokenKind::CloseInterval;
}
static_assert(static_cast<int>(TokenKind::CloseInterval) - static_cast<int>(TokenKind::OpenParen) == 15);

/// Pairs each closer with the nearest open bracket of its kind; what was opened in between stays open there.
class Pairing {
 public:
  Pairing(std::span<const Token> tokens, uint32_t first, uint32_t end) : tokens_(tokens) {
    faults_.first = first;
    faults_.partners.assign(end - first, kNone);
    for (uint32_t i = first; i < end; ++i) {
      const TokenKind kind = tokens[i].kind;
      if (is_opener(kind)) {
        open_.push_back(i);
        ++open_of_kind(closer_of(kind));
      } else if (is_closer(kind)) {
        close(i);
      }
    }
    leave_open_above(0, end);
  }

  BracketFaults result() {
    auto by_opener = [](const UnclosedBracket& a, const UnclosedBracket& b) { return a.opener < b.opener; };
    std::sort(faults_.unclosed.begin(), faults_.unclosed.end(), by_opener);
    faults_.stray_closers = faults_.ignored_closers;
    std::erase_if(faults_.unclosed, [this](UnclosedBracket& bracket) { return is_inside_another(bracket); });
    for (UnclosedBracket& bracket : faults_.unclosed) take_stray_closer(bracket);
    return std::move(faults_);
  }

 private:
  uint32_t& open_of_kind(TokenKind closer) { return open_count_[static_cast<size_t>(closer)]; }

  void close(uint32_t closer) {
    const TokenKind kind = tokens_[closer].kind;
    if (open_of_kind(kind) == 0) {
      faults_.ignored_closers.push_back(closer);
      return;
    }
    size_t opener = open_.size() - 1;
    while (closer_of(tokens_[open_[opener]].kind) != kind) --opener;
    leave_open_above(opener + 1, closer);
    faults_.partners[open_[opener] - faults_.first] = closer;
    open_.pop_back();
    --open_of_kind(kind);
  }

  void leave_open_above(size_t first, uint32_t found) {
    if (first >= open_.size()) return;
    faults_.unclosed.push_back({.opener = open_[first], .found = found, .reach = found});
    for (size_t i = first; i < open_.size(); ++i) --open_of_kind(closer_of(tokens_[open_[i]].kind));
    open_.resize(first);
  }

  bool is_inside_another(const UnclosedBracket& bracket) {
    if (bracket.opener < reported_up_to_) return true;
    reported_up_to_ = bracket.found;
    return false;
  }

  /// `(1]` is one fault, not two: the closer that follows stands where the right one should.
  void take_stray_closer(UnclosedBracket& bracket) {
    auto& strays = faults_.stray_closers;
    const auto stray = std::lower_bound(strays.begin(), strays.end(), bracket.opener);
    if (stray == strays.end()) return;
    if (*stray < bracket.found) bracket.found = *stray;
    strays.erase(stray);
  }

  std::span<const Token> tokens_;
  BracketFaults faults_;
  std::vector<uint32_t> open_;
  std::array<uint32_t, 256> open_count_{};
  uint32_t reported_up_to_ = 0;
};

}  // namespace

TokenKind closer_of(TokenKind opener) {
  if (opener == TokenKind::OpenParen) return TokenKind::CloseParen;
  if (opener == TokenKind::OpenBrace) return TokenKind::CloseBrace;
  if (opener == TokenKind::OpenBracket) return TokenKind::CloseBracket;
  if (opener == TokenKind::OpenSet) return TokenKind::CloseSet;
  if (opener == TokenKind::OpenAngle) return TokenKind::CloseAngle;
  if (opener == TokenKind::OpenCases) return TokenKind::CloseCases;
  if (opener == TokenKind::OpenMatrix) return TokenKind::CloseMatrix;
  if (opener == TokenKind::OpenInterval) return TokenKind::CloseInterval;
  return TokenKind::Unknown;
}

bool is_opener(TokenKind kind) {
  return closer_of(kind) != TokenKind::Unknown;
}

bool is_closer(TokenKind kind) {
  return kind == TokenKind::CloseParen || kind == TokenKind::CloseBrace || kind == TokenKind::CloseBracket ||
         kind == TokenKind::CloseSet || kind == TokenKind::CloseAngle || kind == TokenKind::CloseCases ||
         kind == TokenKind::CloseMatrix || kind == TokenKind::CloseInterval;
}

bool brackets_balance(std::span<const Token> tokens) {
  constexpr size_t kDeepest = 64;  // deeper nesting is judged by the slower way
  std::array<TokenKind, kDeepest> expected;
  size_t depth = 0;
  for (const Token& token : tokens) {
    if (!is_bracket(token.kind)) continue;
    if (is_opener(token.kind)) {
      if (depth == kDeepest) return false;
      expected[depth++] = closer_of(token.kind);
    } else {
      if (depth == 0 || expected[depth - 1] != token.kind) return false;
      --depth;
    }
  }
  return depth == 0;
}

BracketFaults find_bracket_faults(std::span<const Token> tokens, uint32_t first, uint32_t end) {
  return Pairing(tokens, first, end).result();
}

}  // namespace texbrdf
