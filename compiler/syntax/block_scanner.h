#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "source/span.h"

namespace texbrdf {

/// How a math block ended.
enum class BlockEnd : uint8_t {
  Closed,     ///< by the \end of its own environment
  WrongEnd,   ///< by an \end of another environment
  NextBegin,  ///< by the next \begin of an equation
  BlankLine,
  DocumentEnd,  ///< \end{document} or the end of the file
};

/// One math block, in bytes of the document. [whole.begin, whole.end) is what the block owns: all its other spans are
/// relative to whole.begin.
struct BlockExtent {
  Span whole;    ///< absolute; from the backslash of \begin to behind \end{…}, or to where the block was broken off
  Span begin;    ///< relative: the \begin{equation}
  Span content;  ///< relative: between \begin{…} and \end
  Span end;      ///< relative: the `\end` token itself (4 bytes) where one closes the block, else empty at content.end
  BlockEnd ended_by = BlockEnd::Closed;
};

/// Finds the math blocks of a LaTeX document (language.md, section 1). Never fails; linear in the text.
std::vector<BlockExtent> scan_blocks(std::string_view document);

}  // namespace texbrdf
