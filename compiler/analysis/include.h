#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "syntax/block_scanner.h"

namespace texbrdf {

/// The file that a command of prose asks for, as the document writes it. Which one that is, only the server can tell.
struct IncludeTarget {
  IncludeCommand::Kind kind = IncludeCommand::Kind::Input;
  std::string folder;  ///< empty where the command names none
  std::string path;
  friend auto operator<=>(const IncludeTarget&, const IncludeTarget&) = default;
};

struct Include {
  IncludeTarget target;
  Span span;  ///< of the command, relative to its part of the document
};

/// An include that could not be followed, and why.
struct IncludeProblem {
  FileId file;  ///< the one that it stands in
  IncludeTarget target;
  Code code;
  std::string argument;  ///< of the message
  friend bool operator==(const IncludeProblem&, const IncludeProblem&) = default;
};

/// The file that a document says it is a part of: PATH of a comment `% !TeX root = PATH` in its first lines, else of
/// `\documentclass[PATH]{subfiles}`.
std::optional<std::string> read_root(std::string_view document);

}  // namespace texbrdf
