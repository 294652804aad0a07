#pragma once

#include <string>
#include <vector>

#include "analysis/document.h"

namespace texbrdf::test {

/// "code line:column [underlined] message" of each diagnostic, at most `least_severe`.
inline std::vector<std::string> reports(const Snapshot& snapshot, Severity least_severe = Severity::Hint,
                                        std::string_view root = "f") {
  std::vector<std::string> lines;
  for (const Diagnostic& d : snapshot.diagnostics(root)) {
    if (d.severity > least_severe) continue;
    const Span span = snapshot.absolute(d.where);
    const Position at = snapshot.text().position(span.begin, ColumnUnit::CodePoint);
    lines.push_back(code_name(d.code) + " " + std::to_string(at.line + 1) + ":" + std::to_string(at.column + 1) + " [" +
                    std::string(snapshot.text().slice(span)) + "] " + message(d));
  }
  return lines;
}

/// A document of equations, one a block, without \begin and \end.
inline std::string equations(const std::vector<std::string>& bodies) {
  std::string text;
  for (const std::string& body : bodies) text += "\\begin{equation}\n" + body + "\n\\end{equation}\n\n";
  return text;
}

}  // namespace texbrdf::test
