#include "features/document_highlights.h"

namespace texbrdf::features {

std::vector<Highlight> document_highlights(const Snapshot& snapshot, uint32_t offset) {
  std::vector<Highlight> highlights;
  const auto occurrence = snapshot.occurrence_at(offset);
  if (!occurrence) return highlights;
  for (const Occurrence& found : snapshot.occurrences_of(*occurrence)) {
    if (snapshot.is_in_file(found.span)) highlights.push_back({found.span, found.is_definition});
  }
  return highlights;
}

}  // namespace texbrdf::features
