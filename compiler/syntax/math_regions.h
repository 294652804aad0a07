#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace texbrdf {

/// What stands around mathematics in prose.
enum class MathRegion : uint8_t {
  Environment,      ///< \begin{equation} … \end{equation}
  Brackets,         ///< \[ … \]
  DoubleDollars,    ///< $$ … $$
  Parentheses,      ///< \( … \)
  Dollars,          ///< $ … $
  Shortcut,         ///< \be … \ee, from math_regions.def
  Fence,            ///< of Markdown: ```math … ```
  BacktickDollars,  ///< of Markdown: $`…`$
};

constexpr bool is_inline(MathRegion region) {
  return region == MathRegion::Parentheses || region == MathRegion::Dollars || region == MathRegion::BacktickDollars;
}
/// Empty for an environment and a shortcut.
std::string_view opener_of(MathRegion region);
std::string_view closer_of(MathRegion region);

/// An environment that holds mathematics, from math_regions.def.
struct MathEnvironment {
  enum class Role : uint8_t { Display, Inner, Cases, Matrix };
  std::string_view name;  ///< without its star
  Role role;
  bool has_columns;   ///< `&` separates them
  bool has_argument;  ///< `\begin{alignat}{2}`

  /// It is an operand of an expression.
  bool is_operand() const { return role == Role::Cases || role == Role::Matrix; }
};

/// One for each environment that is known, to count with: `find_math_environment(…) - math_environments().data()`.
std::span<const MathEnvironment> math_environments();

/// Commands that papers define for the begin and the end of a display.
struct MathShortcut {
  std::string_view opener;  ///< without backslash
  std::string_view closer;
  bool has_columns;
};
/// By its opener; nullptr for any other word.
const MathShortcut* find_math_shortcut(std::string_view opener);

/// By its name, with or without a star; nullptr for any other environment.
const MathEnvironment* find_math_environment(std::string_view name);
/// `cases` of `\begin{cases}` or its `\end`; empty where there is none.
std::string_view environment_name(std::string_view begin);
bool is_display_environment(std::string_view name);

}  // namespace texbrdf
