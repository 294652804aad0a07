#include "features/diagnostics.h"

namespace texbrdf::features {

std::vector<ShownDiagnostic> diagnostics(const Snapshot& snapshot) {
  std::vector<ShownDiagnostic> shown;
  for (const Diagnostic& diagnostic : snapshot.diagnostics()) {
    ShownDiagnostic& added = shown.emplace_back(ShownDiagnostic{
        snapshot.absolute(diagnostic.where), diagnostic.severity, code_name(diagnostic.code), message(diagnostic), {}});
    for (const RelatedPlace& place : diagnostic.related) {
      added.related.push_back({snapshot.absolute(place.where), place.message});
    }
  }
  return shown;
}

}  // namespace texbrdf::features
