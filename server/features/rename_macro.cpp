#include "features/rename_macro.h"

#include <fmt/format.h>

#include <algorithm>

#include "features/places.h"
#include "semantics/conventions.h"
#include "semantics/name_traits.h"
#include "source/characters.h"
#include "syntax/control_words.h"
#include "syntax/macro_definition.h"

namespace texbrdf::features {
namespace {

bool is_command(std::string_view word) {
  return find_control_word(word).meaning != WordMeaning::Name || is_greek_letter(word) || defines_macros(word) ||
         find_convention(fmt::format("\\{}", word)) || word == "begin" || word == "end";
}

/// Why the macro keeps its name; empty where it need not.
std::string refusal(const MacroOccurrence& macro) {
  if (is_command(macro.name)) return fmt::format("`\\{}` is a command of LaTeX and keeps its name", macro.name);
  return {};
}

/// Why it cannot be called so; empty where it can.
std::string conflict(const Snapshot& snapshot, std::string_view word) {
  if (word.empty() || !std::ranges::all_of(word, is_letter)) return "a macro's name is made of letters";
  if (is_command(word)) return fmt::format("`\\{}` is a command of LaTeX", word);
  const std::vector<Span> places = snapshot.places_of_macro(word);
  if (places.empty()) return {};
  return fmt::format("`\\{}` stands on {} already", word, line_name(snapshot, places.front().begin));
}

}  // namespace

Result<std::optional<RenameTarget>> renamable_macro_at(const Snapshot& snapshot, uint32_t offset) {
  const std::optional<MacroOccurrence> macro = snapshot.macro_at(offset);
  if (!macro) return std::optional<RenameTarget>{};
  if (std::string reason = refusal(*macro); !reason.empty()) return Failure{std::move(reason)};
  return std::optional(RenameTarget{macro->span, "\\" + macro->name});
}

Result<std::vector<TextEdit>> rename_macro(const Snapshot& snapshot, uint32_t offset, std::string_view new_name) {
  const std::optional<MacroOccurrence> macro = snapshot.macro_at(offset);
  if (!macro) return Failure{"no name stands here"};
  if (std::string reason = refusal(*macro); !reason.empty()) return Failure{std::move(reason)};
  const std::string_view word = new_name.starts_with('\\') ? new_name.substr(1) : new_name;
  if (word != macro->name) {
    if (std::string reason = conflict(snapshot, word); !reason.empty()) return Failure{std::move(reason)};
  }
  std::vector<TextEdit> edits;
  for (const Span place : snapshot.places_of_macro(macro->name)) edits.push_back({place, fmt::format("\\{}", word)});
  return edits;
}

}  // namespace texbrdf::features
