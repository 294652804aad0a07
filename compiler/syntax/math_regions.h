#pragma once

#include <cstdint>
#include <string_view>

namespace texbrdf {

/// What stands around mathematics in prose.
enum class MathRegion : uint8_t {
  Environment,    ///< \begin{equation} … \end{equation}
  Brackets,       ///< \[ … \]
  DoubleDollars,  ///< $$ … $$
  Parentheses,    ///< \( … \)
  Dollars,        ///< $ … $
};

constexpr bool is_inline(MathRegion region) {
  return region == MathRegion::Parentheses || region == MathRegion::Dollars;
}
/// Empty for an environment.
std::string_view opener_of(MathRegion region);
std::string_view closer_of(MathRegion region);

/// An environment whose rows are equations, from math_regions.def.
struct MathEnvironment {
  enum class Role : uint8_t { Display, Inner };
  std::string_view name;  ///< without its star
  Role role;
  bool has_columns;   ///< `&` separates them
  bool has_argument;  ///< `\begin{alignat}{2}`
};

/// By its name, with or without a star; nullptr for any other environment.
const MathEnvironment* find_math_environment(std::string_view name);
bool is_display_environment(std::string_view name);

}  // namespace texbrdf
