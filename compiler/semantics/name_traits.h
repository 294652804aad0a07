#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "semantics/builtin_functions.h"
#include "semantics/conventions.h"

namespace texbrdf {

/// What the spelling of a name says by itself.
struct NameTraits {
  std::optional<Convention> convention;
  std::optional<Convention> usual_meaning;  ///< of a name that is no convention: what papers mean that do not define it
  bool is_vector = false;                   ///< a parameter of this name is ℝ³ by its spelling
  bool is_reserved = false;                 ///< `exp`, `max` … without backslash
  bool may_be_brdf = false;                 ///< `f`, `f_r`, `f_{…}`: a name that papers give to a BRDF
  bool may_be_brdf_or_albedo = false;       ///< `\rho`, `\rho_{bd}`: a BRDF only where it is a function of directions
  std::optional<Builtin> builtin;           ///< a function that needs no definition
  bool is_foreign_command = false;          ///< a `\word` that is neither a Greek letter nor a convention

  /// What the name is where nothing defines it.
  std::optional<Convention> meaning() const { return convention ? convention : usual_meaning; }
  /// Where no definition gives the name another meaning, it is a direction of the convention, or an angle.
  bool is_directional() const { return meaning() && !convention_constant(*meaning()); }
};

NameTraits name_traits(std::string_view canonical);
/// Without their backslashes.
std::span<const std::string_view> greek_letters();
bool is_greek_letter(std::string_view word_without_backslash);
bool is_reserved_word(std::string_view word);

}  // namespace texbrdf
