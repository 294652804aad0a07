#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "source/span.h"
#include "source/text_language.h"
#include "syntax/formula_end.h"
#include "syntax/macro_definition.h"

namespace texbrdf {

/// One math block, in bytes of the document. [whole.begin, whole.end) is what the block owns: all its other spans are
/// relative to whole.begin.
struct BlockExtent {
  /// Absolute; from the backslash of \begin (or the first comment `% texbrdf:`, `<!-- texbrdf:` right above) to behind
  /// \end{…}, or to where the block was broken off.
  Span whole;
  Span begin;    ///< relative: the \begin{equation}, \[, $$ …
  Span content;  ///< relative: between that and what closes it
  Span end;      ///< relative: `\end` (4 bytes), `\]`, `$$` … where it closes the block, else empty at content.end
  BlockEnd ended_by = BlockEnd::Closed;
  MathRegion region = MathRegion::Environment;
  friend bool operator==(const BlockExtent&, const BlockExtent&) = default;
};

/// A command of prose that reads another file: `\input{path}`, `\import{folder/}{path}`.
struct IncludeCommand {
  /// Which folders the path is looked for in.
  enum class Kind : uint8_t {
    Input,     ///< that of the root, then that of the file
    Subfile,   ///< that of the file, then that of the root
    Import,    ///< `folder` in that of the root
    SubImport  ///< `folder` in that of the file
  };
  Kind kind = Kind::Input;
  Span span;    ///< of the command with its groups, relative to the part
  Span folder;  ///< relative; empty where the command has none
  Span path;    ///< relative
};

/// A part of a document: one math block, or prose. Parts follow each other without gaps; each begins where nothing is
/// open, so what a part is depends on nothing before it; in Markdown, on whether it starts a line.
struct DocumentPart {
  uint32_t begin = 0;  ///< absolute
  uint32_t size = 0;
  /// How many bytes from its begin decided what it is, at least `size` (a block that is not closed is ended by
  /// something further on).
  uint32_t reach = 0;
  std::optional<BlockExtent> block;
  std::vector<Span>
      directives;  ///< of prose: its comments `texbrdf: …`, relative; those above a block are in the block
  std::vector<IncludeCommand> includes;  ///< of prose
  std::vector<MacroDefinition> macros;   ///< relative
  /// After \end{document}: whatever follows belongs to it.
  bool is_epilogue = false;
};

/// Walks a document from part to part. Inline mathematics that holds no `=` is prose, and so is what is not closed.
/// Never fails; linear in the text.
class BlockScanner {
 public:
  /// `text` begins with a part. Where `is_whole` is false, more follows behind it that is not shown.
  BlockScanner(std::string_view text, bool is_whole) : BlockScanner(text, is_whole, TextLanguage::Latex, true) {}
  /// `starts_line`: nothing stands before the text in its line.
  BlockScanner(std::string_view text, bool is_whole, TextLanguage language, bool starts_line);
  ~BlockScanner();
  /// Nothing at the end, or where only what follows could tell.
  std::optional<DocumentPart> next();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

std::vector<DocumentPart> scan_parts(std::string_view document, TextLanguage language = TextLanguage::Latex);
/// The math blocks alone.
std::vector<BlockExtent> scan_blocks(std::string_view document, TextLanguage language = TextLanguage::Latex);

}  // namespace texbrdf
