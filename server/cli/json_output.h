#pragma once

#include <span>
#include <string>

#include "cli/checked_file.h"

namespace texbrdf::cli {

/// A list of {file, code, severity, message, range, related, fixes}; lines and columns count from 1, columns in
/// Unicode code points, ends are exclusive.
std::string diagnostics_json(std::span<const CheckedFile> files);

/// The syntax tree of each definition: {name, type, tree: {kind, range, text, type, children}}.
std::string tree_json(const Snapshot& snapshot);

}  // namespace texbrdf::cli
