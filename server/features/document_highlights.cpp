#include "features/document_highlights.h"

namespace texbrdf::features {

namespace {

std::vector<Highlight> macro_highlights(const Snapshot& snapshot, uint32_t offset) {
  std::vector<Highlight> highlights;
  const auto macro = snapshot.macro_at(offset);
  if (!macro) return highlights;
  for (const Span place : snapshot.places_of_macro(macro->name)) {
    if (snapshot.is_in_file(place)) highlights.push_back({place, place == macro->definition_name});
  }
  return highlights;
}

}  // namespace

std::vector<Highlight> document_highlights(const Snapshot& snapshot, uint32_t offset) {
  std::vector<Highlight> highlights;
  const auto occurrence = snapshot.occurrence_at(offset);
  if (!occurrence) return macro_highlights(snapshot, offset);
  for (const Occurrence& found : snapshot.occurrences_of(*occurrence)) {
    if (snapshot.is_in_file(found.span)) highlights.push_back({found.span, found.is_definition});
  }
  return highlights;
}

}  // namespace texbrdf::features
