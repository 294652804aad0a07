#include "syntax/statements.h"

#include <algorithm>
#include <array>

#include "source/characters.h"
#include "syntax/operators.h"

namespace texbrdf {
namespace {

/// Words between two statements of a display, or between a statement and what it holds for.
constexpr auto kConnectives = std::to_array<std::string_view>(
    {"where", "with", "and",   "for", "if",   "when", "then", "so",    "that",    "hence", "thus", "therefore", "in",
     "at",    "or",   "which", "as",  "here", "let",  "such", "since", "because", "is",    "are",  "otherwise", "on"});

/// The first word of `\text{ where }`; empty where something else comes first.
std::string_view first_word(std::string_view text_token) {
  std::string_view word = text_token.substr(std::min(text_token.find('{') + 1, text_token.size()));
  while (!word.empty() && (word.front() == ' ' || word.front() == '~' || word.front() == ',')) word.remove_prefix(1);
  return word.substr(0, static_cast<size_t>(std::ranges::find_if_not(word, is_letter) - word.begin()));
}

class Splitter {
 public:
  Splitter(std::span<const Token> tokens, std::string_view text, const BracketFaults* faults)
      : tokens_(tokens), text_(text), faults_(faults), end_(static_cast<uint32_t>(tokens.size()) - 1) {}

  std::vector<Statement> run() {
    for (uint32_t token = 0; token < end_; ++token) {
      count_bracket(token);
      if (depth_ > 0) continue;
      if (is_connective(token)) {
        finish(token);
        begin_ = token + 1;
      } else if (is_separator(token)) {
        note_separator(token);
      } else if (is_relation(token)) {
        note_relation(token);
      }
    }
    finish(end_);
    if (statements_.empty()) statements_.push_back({0, end_, end_, end_});
    return std::move(statements_);
  }

 private:
  TokenKind kind(uint32_t token) const { return tokens_[token].kind; }
  std::string_view token_text(uint32_t token) const {
    return text_.substr(tokens_[token].span.begin, tokens_[token].span.size());
  }
  bool is_relation(uint32_t token) const {
    return kind(token) == TokenKind::Equals || kind(token) == TokenKind::Relation;
  }
  bool is_connective(uint32_t token) const {
    if (kind(token) != TokenKind::Text || is_script(token)) return false;
    const bool is_remark = token > 0 && is_layout(kind(token - 1)) && first_word(token_text(token)).empty();
    return is_remark || std::ranges::find(kConnectives, first_word(token_text(token))) != kConnectives.end();
  }
  bool is_script(uint32_t token) const {
    return token > 0 && (kind(token - 1) == TokenKind::Underscore || kind(token - 1) == TokenKind::Caret);
  }
  /// Cells and rows that are no display's stand at this level only where their environment has no end.
  bool is_separator(uint32_t token) const {
    return is_layout(kind(token)) || is_punctuation(token) || kind(token) == TokenKind::CellEnd ||
           kind(token) == TokenKind::RowEnd;
  }
  bool is_punctuation(uint32_t token) const {
    if (kind(token) == TokenKind::Comma) return true;
    return kind(token) == TokenKind::Unknown && (token_text(token) == "." || token_text(token) == ":");
  }

  /// A bracket without partner encloses nothing.
  void count_bracket(uint32_t token) {
    if (is_opener(kind(token))) {
      if (faults_ == nullptr || faults_->partner_of(token) != UINT32_MAX) ++depth_;
    } else if (is_closer(kind(token))) {
      if (faults_ == nullptr || !std::ranges::binary_search(faults_->ignored_closers, token)) --depth_;
    }
  }

  void note_separator(uint32_t token) {
    if (separators_.end != token) {
      before_ = separators_;
      separators_ = {.begin = token, .end = token};
    }
    separators_.end = token + 1;
    if (!is_column(token)) separators_.are_columns = false;
    if (kind(token) == TokenKind::NewRow || kind(token) == TokenKind::RowEnd) separators_.has_new_row = true;
  }

  bool is_column(uint32_t token) const { return kind(token) == TokenKind::Ampersand || token_text(token) == "&"; }

  void note_relation(uint32_t token) {
    // The `&` of `a &= b` separates nothing.
    const bool is_aligned = separators_.are_columns && separators_.end == token;
    const Separators last = is_aligned ? before_ : separators_;
    const bool may_end_here = has_relation_ || last.has_new_row;
    if (may_end_here && last.end > begin_ && begins_left_side(last.end, token)) {
      finish(last.begin);
      begin_ = last.end;
    }
    if (!has_relation_) {
      relation_ = token;
    } else if (chain_ == kNone) {
      chain_ = token;
    }
    has_relation_ = true;
    separators_ = before_ = {};
  }

  bool begins_left_side(uint32_t first, uint32_t relation) const {
    if (first >= relation) return false;
    const TokenKind begin = kind(first);
    return role_of(begin).begins_operand || begin == TokenKind::Bar || begin == TokenKind::DoubleBar;
  }

  void finish(uint32_t end) {
    uint32_t begin = begin_;
    while (begin < end && is_separator(begin)) ++begin;
    while (end > begin && is_separator(end - 1)) --end;
    if (const uint32_t number = equation_number(begin, end); number != end) {
      end = number;
      while (end > begin && is_separator(end - 1)) --end;
    }
    if (begin < end) {
      const uint32_t relation = has_relation_ ? relation_ : end;
      statements_.push_back({begin, end, relation, chain_ == kNone ? end : chain_});
    }
    has_relation_ = false;
    chain_ = kNone;
    separators_ = before_ = {};
  }

  /// Where `\qquad (12)` begins at the end of a statement that has something before it, else `end`.
  uint32_t equation_number(uint32_t begin, uint32_t end) const {
    constexpr uint32_t kLength = 3;
    const uint32_t first = end - std::min(end, kLength);
    const bool is_number = end - first == kLength && first > begin + 1 && kind(first) == TokenKind::OpenParen &&
                           kind(first + 1) == TokenKind::Number && kind(first + 2) == TokenKind::CloseParen;
    const bool stands_apart = is_number && kind(first - 1) == TokenKind::Gap && !is_column(first - 1);
    if (!stands_apart || token_text(first + 1).find('.') != std::string_view::npos) return end;
    uint32_t before = first;
    while (before > begin && is_layout(kind(before - 1))) --before;
    const TokenKind last = kind(before - 1);
    return is_relation(before - 1) || role_of(last).infix != 0 ? end : first;
  }

  static constexpr uint32_t kNone = UINT32_MAX;
  struct Separators {
    uint32_t begin = 0;
    uint32_t end = 0;
    bool are_columns = true;
    bool has_new_row = false;
  };

  std::span<const Token> tokens_;
  std::string_view text_;
  const BracketFaults* faults_;
  const uint32_t end_;
  uint32_t depth_ = 0;
  uint32_t begin_ = 0;
  bool has_relation_ = false;
  uint32_t relation_ = 0;
  uint32_t chain_ = kNone;
  Separators separators_;  // the last ones behind the last relation, side by side
  Separators before_;      // and those before them
  std::vector<Statement> statements_;
};

}  // namespace

std::vector<Statement> split_statements(std::span<const Token> tokens, std::string_view text,
                                        const BracketFaults* faults) {
  return Splitter(tokens, text, faults).run();
}

}  // namespace texbrdf
