#pragma once

#include <string>
#include <vector>

#include "analysis/snapshot.h"
#include "features/diagnostics.h"
#include "features/text_edit.h"

namespace texbrdf::features {

/// One way to mend a problem.
struct CodeAction {
  std::string title;
  std::vector<TextEdit> edits;
  ShownDiagnostic diagnostic;
  bool is_preferred = false;  ///< there is no other that is as likely to be meant
};

/// For the problems that the range touches, in document order.
std::vector<CodeAction> code_actions(const Snapshot& snapshot, Span range);

}  // namespace texbrdf::features
