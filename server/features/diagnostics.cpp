#include "features/diagnostics.h"

#include "features/numeric_diagnostics.h"

namespace texbrdf::features {

ShownDiagnostic shown(const Snapshot& snapshot, const Diagnostic& diagnostic) {
  ShownDiagnostic result{snapshot.absolute(diagnostic.where),
                         diagnostic.severity,
                         code_name(diagnostic.code),
                         message(diagnostic),
                         {},
                         false};
  result.is_unnecessary = diagnostic.code == Code::UnusedDefinition || diagnostic.code == Code::UnusedParameter;
  for (const RelatedPlace& place : diagnostic.related) {
    result.related.push_back({snapshot.absolute(place.where), place.message});
  }
  return result;
}

std::vector<ShownDiagnostic> diagnostics(const Snapshot& snapshot, const NumericFindings* findings) {
  std::vector<ShownDiagnostic> all;
  if (!snapshot.is_ours()) return all;
  for (const Diagnostic& diagnostic : diagnostics_with(snapshot, findings)) {
    if (snapshot.is_in_file(snapshot.absolute(diagnostic.where))) all.push_back(shown(snapshot, diagnostic));
  }
  return all;
}

std::vector<std::vector<ShownDiagnostic>> diagnostics_by_file(const Snapshot& snapshot,
                                                              const NumericFindings* findings) {
  std::vector<std::vector<ShownDiagnostic>> files(snapshot.file_count());
  if (!snapshot.is_ours()) return files;
  for (const Diagnostic& diagnostic : diagnostics_with(snapshot, findings)) {
    const FileId file = snapshot.place(snapshot.absolute(diagnostic.where)).file;
    files[file.value].push_back(shown(snapshot, diagnostic));
  }
  return files;
}

}  // namespace texbrdf::features
