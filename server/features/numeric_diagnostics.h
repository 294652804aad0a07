#pragma once

#include <string_view>
#include <vector>

#include "analysis/snapshot.h"
#include "features/numeric_findings.h"

namespace texbrdf::features {

/// What is to be said of a document, in document order: Snapshot::diagnostics, and what was found by computing. A chain
/// whose right sides differ for some directions has a warning with the first one that shows it; inexact integrals have
/// a hint; and it is nothing that `\vec{h}` is defined as what it is. Without findings, which have to hold for the
/// snapshot, nothing is said of all that. `root`: as for Snapshot::diagnostics.
std::vector<Diagnostic> diagnostics_with(const Snapshot& snapshot, const NumericFindings* findings,
                                         std::string_view root = {});

/// With all that can be found.
std::vector<Diagnostic> all_diagnostics(const Snapshot& snapshot, std::string_view root = {});

}  // namespace texbrdf::features
