#pragma once

#include <string>
#include <vector>

#include "analysis/snapshot.h"

namespace texbrdf::cli {

/// What `check` found in one file.
struct CheckedFile {
  std::string name;
  const Snapshot* snapshot = nullptr;
  std::vector<Diagnostic> diagnostics;
};

}  // namespace texbrdf::cli
