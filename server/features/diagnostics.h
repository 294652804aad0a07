#pragma once

#include <string>
#include <vector>

#include "analysis/snapshot.h"

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
};

ShownDiagnostic shown(const Snapshot& snapshot, const Diagnostic& diagnostic);
/// All diagnostics of the document, in document order.
std::vector<ShownDiagnostic> diagnostics(const Snapshot& snapshot);

}  // namespace texbrdf::features
