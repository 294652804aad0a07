#include "syntax/macro_table.h"

#include "syntax/control_words.h"

namespace texbrdf {

MacroTable::MacroTable(const std::vector<const MacroDefinition*>& definitions) {
  for (uint32_t i = 0; i < definitions.size(); ++i) {
    const MacroDefinition& definition = *definitions[i];
    const bool is_known =
        entries_.contains(definition.name) || find_control_word(definition.name).meaning != WordMeaning::Name;
    if (definition.form == MacroForm::Provided && is_known) continue;
    Macro macro = meaning_of(definition);
    entries_.insert_or_assign(definition.name, Entry{std::move(macro), i});
  }
}

Macro MacroTable::meaning_of(const MacroDefinition& definition) const {
  if (definition.form == MacroForm::Copy) {
    const bool is_word = definition.body.starts_with('\\');
    if (const Macro* original = is_word ? find(std::string_view(definition.body).substr(1)) : nullptr) return *original;
    return {.fallback = {}, .body = definition.body, .is_original = true};
  }
  return {.parameters = definition.parameters,
          .fallback = definition.fallback,
          .body = definition.body,
          .takes_size = definition.form == MacroForm::Brackets};
}

const Macro* MacroTable::find(std::string_view name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() ? nullptr : &found->second.macro;
}

std::optional<uint32_t> MacroTable::definition_of(std::string_view name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() ? std::nullopt : std::optional(found->second.definition);
}

/// By word, the macros whose bodies mention it.
void MacroTable::list_users(Users& users) const {
  for (const auto& [name, entry] : entries_) {
    if (entry.macro.is_original) continue;
    const auto note = [&, user = std::string_view(name)](std::string_view word) {
      users[word].push_back(user);
      return true;
    };
    visit_control_words(entry.macro.body, note);
    if (entry.macro.fallback) visit_control_words(*entry.macro.fallback, note);
  }
}

WordSet MacroTable::changed_since(const MacroTable& before) const {
  WordSet changed;
  std::vector<std::string_view> open;
  const auto note = [&](std::string_view name) {
    const auto [place, is_new] = changed.emplace(name);
    if (is_new) open.push_back(*place);
  };
  for (const auto& [name, entry] : entries_) {
    const Macro* const old = before.find(name);
    if (old == nullptr || *old != entry.macro) note(name);
  }
  for (const auto& [name, entry] : before.entries_) {
    if (find(name) == nullptr) note(name);
  }
  if (open.empty()) return changed;
  Users users;
  list_users(users);
  before.list_users(users);
  while (!open.empty()) {
    const auto found = users.find(open.back());
    open.pop_back();
    if (found == users.end()) continue;
    for (std::string_view user : found->second) note(user);
  }
  return changed;
}

bool holds_word_of(const WordSet& words, std::string_view text) {
  bool found = false;
  visit_control_words(text, [&](std::string_view word) {
    found = words.contains(word);
    return !found;
  });
  return found;
}

}  // namespace texbrdf
