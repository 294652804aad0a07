#include "cli/messages.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "diagnostics/render_terminal.h"

namespace texbrdf::cli {

void print_message(std::string_view text) {
  fmt::print(stderr, "texbrdf: {}\n", text);
}

Place place_of(const Snapshot& snapshot, std::span<const std::string> names, const Location& where) {
  const FilePlace place = snapshot.place(snapshot.absolute(where));
  return {.file = names[place.file.value], .text = &snapshot.text(place.file), .span = place.span};
}

std::string terminal_text(const Snapshot& snapshot, std::span<const Diagnostic> diagnostics,
                          std::span<const std::string> names, bool colour) {
  const auto find_place = [&](const Location& where) { return place_of(snapshot, names, where); };
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) {
    text += render_terminal(diagnostic, find_place, {.colour = colour});
  }
  return text;
}

void report_errors_and_warnings(const Snapshot& snapshot, std::span<const Diagnostic> diagnostics,
                                std::span<const std::string> names) {
  std::vector<Diagnostic> shown;
  std::copy_if(diagnostics.begin(), diagnostics.end(), std::back_inserter(shown),
               [](const Diagnostic& d) { return d.severity <= Severity::Warning; });
  fmt::print(stderr, "{}", terminal_text(snapshot, shown, names, wants_colour(STDERR_FILENO)));
}

bool has_error(std::span<const Diagnostic> diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

bool wants_colour(int file_descriptor) {
  const char* const refused = std::getenv("NO_COLOR");
  return ::isatty(file_descriptor) == 1 && (refused == nullptr || *refused == '\0');
}

}  // namespace texbrdf::cli
