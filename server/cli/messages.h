#pragma once

#include <span>
#include <string>
#include <string_view>

#include "analysis/snapshot.h"
#include "diagnostics/render_terminal.h"

namespace texbrdf::cli {

/// One line for a person on standard error: "texbrdf: …".
void print_message(std::string_view text);

/// `names` of the files, by FileId.
Place place_of(const Snapshot& snapshot, std::span<const std::string> names, const Location& where);
/// Diagnostics of a document in terminal form.
std::string terminal_text(const Snapshot& snapshot, std::span<const Diagnostic> diagnostics,
                          std::span<const std::string> names, bool colour);
/// Writes errors and warnings to standard error. Hints are for `check` and editors.
void report_errors_and_warnings(const Snapshot& snapshot, std::span<const Diagnostic> diagnostics,
                                std::span<const std::string> names);
bool has_error(std::span<const Diagnostic> diagnostics);

/// Whether to write colour to a file descriptor: it is a terminal, and the user has not set NO_COLOR.
bool wants_colour(int file_descriptor);

}  // namespace texbrdf::cli
