#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "syntax/math_regions.h"
#include "syntax/token.h"

namespace texbrdf {

/// The environments that are open inside a display while the lexer goes through it, and what a token is in the rows of
/// the innermost one: `&` and `\\` of cases and matrices are no business of the display.
class OpenEnvironments {
 public:
  struct Entry {
    const MathEnvironment* environment = nullptr;
    MathEnvironment::Role role = MathEnvironment::Role::Inner;  ///< Cases also for an array behind `\{`
    bool is_behind_brace = false;
    uint32_t braces = 0;               ///< open in it
    uint32_t brackets = 0;             ///< of all kinds
    std::optional<uint32_t> interval;  ///< the number of brackets around one that is open

    bool is_operand() const { return role == MathEnvironment::Role::Cases || role == MathEnvironment::Role::Matrix; }
    TokenKind opener() const;
    TokenKind closer() const;
  };

  void open(const MathEnvironment& environment, bool is_behind_brace);
  /// What an `\end` closes: the innermost environment of its name with all that is open in it; else, where the name is
  /// nobody's, the innermost of which somebody will ask where it ends.
  std::optional<Entry> close(const MathEnvironment* environment);

  bool in_rows() const { return !open_.empty() && open_.back().is_operand(); }
  /// Words may be remarks here.
  bool in_cases() const {
    return !open_.empty() && open_.back().role == MathEnvironment::Role::Cases && open_.back().braces == 0;
  }
  /// Of a token in the rows of the innermost environment; `before` is the token before it.
  TokenKind kind_in_rows(TokenKind kind, std::string_view text, TokenKind before, std::string_view text_before);

 private:
  static constexpr size_t kMaxEnvironments = 64;

  TokenKind kind_of_bracket(TokenKind kind, TokenKind before, std::string_view text_before);
  static TokenKind kind_in_case(const Entry& rows, TokenKind kind, std::string_view text, TokenKind before);
  void pop();
  uint32_t& count_of(const MathEnvironment& environment);

  std::vector<Entry> open_;
  std::array<uint32_t, kMaxEnvironments> counts_{};  ///< by environment
  uint32_t operands_ = 0;                            ///< open cases and matrices
};

}  // namespace texbrdf
