#include "analysis/macro_places.h"

#include <set>

namespace texbrdf {

MacroPlaces::MacroPlaces(const Snapshot::State& state) : state_(state), all_(macros_of(state.segments)) {
  std::vector<const MacroDefinition*> definitions;
  definitions.reserve(all_.size());
  for (const PlacedMacro& macro : all_) definitions.push_back(macro.definition);
  table_ = MacroTable(definitions);
}

Location MacroPlaces::at(uint32_t macro, Span span) const {
  const uint32_t begin = state_.view.offset(all_[macro].offset + span.begin);
  return {.file = {}, .block = kProse, .span = {begin, begin + span.size()}};
}

std::optional<Location> MacroPlaces::definition_of(std::string_view name) const {
  const std::optional<uint32_t> macro = table_.definition_of(name);
  return macro ? std::optional(at(*macro, all_[*macro].definition->name_span)) : std::nullopt;
}

std::optional<Location> MacroPlaces::whole_definition_of(std::string_view name) const {
  const std::optional<uint32_t> macro = table_.definition_of(name);
  return macro ? std::optional(at(*macro, all_[*macro].definition->span)) : std::nullopt;
}

std::vector<DocumentMacro> MacroPlaces::all() const {
  std::set<std::string_view> names;
  for (const PlacedMacro& macro : all_) names.insert(macro.definition->name);
  std::vector<DocumentMacro> found;
  for (const std::string_view name : names) {
    const Macro* const macro = table_.find(name);
    if (macro == nullptr) continue;
    found.push_back({std::string(name), macro->parameters - (macro->fallback ? 1 : 0), macro->body});
  }
  return found;
}

std::optional<MacroUse> MacroPlaces::defined_at(uint32_t offset) const {
  for (uint32_t i = 0; i < all_.size(); ++i) {
    const MacroDefinition& definition = *all_[i].definition;
    const Span name = at(i, definition.name_span).span;
    if (name.touches(offset)) return MacroUse{definition.name, name, name};
  }
  return std::nullopt;
}

}  // namespace texbrdf
