#include "semantics/name_traits.h"

#include <algorithm>
#include <array>

#include "source/characters.h"
#include "syntax/control_words.h"

namespace texbrdf {
namespace {

constexpr auto kGreekLetters = std::to_array<std::string_view>({
#define GREEK_LETTER(name) #name,
#include "semantics/greek_letters.def"
#undef GREEK_LETTER
});

constexpr std::string_view kVec = "\\vec{";
constexpr std::string_view kHatOfVector = "\\hat{\\vec{";

std::string_view leading_letters(std::string_view text) {
  return text.substr(0, std::find_if_not(text.begin(), text.end(), is_letter) - text.begin());
}

std::string_view without_vec(std::string_view canonical) {
  if (canonical.starts_with(kHatOfVector)) canonical.remove_prefix(kHatOfVector.size());
  while (canonical.starts_with(kVec)) canonical.remove_prefix(kVec.size());
  return canonical;
}

}  // namespace

std::span<const std::string_view> greek_letters() {
  return kGreekLetters;
}

bool is_greek_letter(std::string_view word) {
  return std::ranges::find(kGreekLetters, word) != kGreekLetters.end();
}

bool is_reserved_word(std::string_view word) {
  return reserves_word(find_command(word));
}

NameTraits name_traits(std::string_view canonical) {
  NameTraits traits;
  traits.convention = find_convention(canonical);
  if (!traits.convention) traits.usual_meaning = find_usual_name(canonical);
  const bool is_direction = traits.convention == Convention::OmegaI || traits.convention == Convention::OmegaO;
  traits.is_vector = canonical.starts_with(kVec) || canonical.starts_with(kHatOfVector) || is_direction;
  traits.builtin = find_builtin(canonical);
  traits.may_be_brdf = canonical == "f" || canonical.starts_with("f_");
  traits.may_be_brdf_or_albedo = canonical == "\\rho" || canonical.starts_with("\\rho_");
  const std::string_view base = without_vec(canonical);
  if (!base.starts_with('\\')) {
    traits.is_reserved = is_reserved_word(leading_letters(base));
    return traits;
  }
  const std::string_view command = leading_letters(base.substr(1));
  const bool is_decoration = base.substr(1 + command.size()).starts_with('{');
  traits.is_foreign_command = !is_decoration && !traits.convention && !is_greek_letter(command);
  return traits;
}

}  // namespace texbrdf
