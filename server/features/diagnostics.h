#pragma once

#include <string>
#include <vector>

#include "analysis/snapshot.h"
#include "features/numeric_findings.h"

namespace texbrdf::features {

struct RelatedText {
  Span span;
  std::string message;
};

/// A diagnostic as it is shown: formed text, absolute ranges.
struct ShownDiagnostic {
  Span span;
  Severity severity;
  std::string code;
  std::string message;
  std::vector<RelatedText> related;
  bool is_unnecessary = false;  ///< nothing would be lost without it: editors show it faded
};

ShownDiagnostic shown(const Snapshot& snapshot, const Diagnostic& diagnostic);
/// All diagnostics of the file, in document order. None for a document that has nothing to do with BRDFs: another
/// LaTeX server may serve it. `findings`: as for diagnostics_with.
std::vector<ShownDiagnostic> diagnostics(const Snapshot& snapshot, const NumericFindings* findings);
/// The same of each file of the project, by FileId; spans are still the snapshot's.
std::vector<std::vector<ShownDiagnostic>> diagnostics_by_file(const Snapshot& snapshot,
                                                              const NumericFindings* findings);

}  // namespace texbrdf::features
