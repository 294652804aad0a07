#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "diagnostics/diagnostic.h"
#include "source/source_text.h"

namespace texbrdf {

/// Where a Location lies: a file as a person knows it, its text, and an absolute range in it.
struct Place {
  std::string_view file;
  const SourceText* text = nullptr;
  Span span;
};

using PlaceFinder = std::function<Place(const Location&)>;

struct TerminalStyle {
  bool colour = false;
};

/// `file(line:column) error: message [code]`, the line before, the line, carets under the range; then related places as
/// notes and the fixes. Lines and columns count from 1, columns in code points. Every line ends with "\n".
std::string render_terminal(const Diagnostic& diagnostic, const PlaceFinder& find_place, TerminalStyle style = {});

}  // namespace texbrdf
