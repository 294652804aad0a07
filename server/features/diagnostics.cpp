#include "features/diagnostics.h"

namespace texbrdf::features {

ShownDiagnostic shown(const Snapshot& snapshot, const Diagnostic& diagnostic) {
  ShownDiagnostic result{
      snapshot.absolute(diagnostic.where), diagnostic.severity, code_name(diagnostic.code), message(diagnostic), {}};
  for (const RelatedPlace& place : diagnostic.related) {
    result.related.push_back({snapshot.absolute(place.where), place.message});
  }
  return result;
}

std::vector<ShownDiagnostic> diagnostics(const Snapshot& snapshot) {
  std::vector<ShownDiagnostic> all;
  for (const Diagnostic& diagnostic : snapshot.diagnostics()) all.push_back(shown(snapshot, diagnostic));
  return all;
}

}  // namespace texbrdf::features
