#include "syntax/verbatim.h"

namespace texbrdf {

size_t end_of_verb(std::string_view text, size_t behind_word) {
  const auto at_line_end = [text](size_t at) { return at >= text.size() || text[at] == '\r' || text[at] == '\n'; };
  size_t at = behind_word;
  if (!at_line_end(at) && text[at] == '*') ++at;
  if (at_line_end(at)) return at;
  const char delimiter = text[at++];
  // Step by step: to look for the line's end first would not be linear in a long line.
  while (!at_line_end(at) && text[at] != delimiter) ++at;
  return at_line_end(at) ? at : at + 1;
}

bool is_raw_environment(std::string_view name) {
  return name == "verbatim" || name == "verbatim*" || name == "lstlisting" || name == "comment";
}

}  // namespace texbrdf
