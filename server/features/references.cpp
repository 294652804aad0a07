#include "features/references.h"

#include <vector>

namespace texbrdf::features {

std::vector<Span> references(const Snapshot& snapshot, uint32_t offset, bool include_declaration) {
  std::vector<Span> spans;
  const auto occurrence = snapshot.occurrence_at(offset);
  if (!occurrence) {
    const auto macro = snapshot.macro_at(offset);
    if (!macro) return spans;
    spans = snapshot.places_of_macro(macro->name);
    if (!include_declaration) std::erase(spans, macro->definition_name);
    return spans;
  }
  for (const Occurrence& found : snapshot.occurrences_of(*occurrence)) {
    if (include_declaration || !found.is_definition) spans.push_back(found.span);
  }
  return spans;
}

}  // namespace texbrdf::features
