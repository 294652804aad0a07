#pragma once

#include <span>
#include <string>
#include <vector>

#include "analysis/snapshot.h"
#include "cli/messages.h"

namespace texbrdf::cli {

/// What `check` found in one file and those that it includes.
struct CheckedFile {
  std::span<const std::string> names;  ///< by FileId
  const Snapshot* snapshot = nullptr;
  std::vector<Diagnostic> diagnostics;

  Place place(const Location& where) const { return place_of(*snapshot, names, where); }
};

}  // namespace texbrdf::cli
