#pragma once

#include <string>
#include <string_view>

#include "source/internal_error.h"
#include "syntax/parsed_block.h"

namespace texbrdf::test {

/// The first block of a document.
inline ParsedBlock parse_first_block(std::string_view document) {
  const std::vector<BlockExtent> blocks = scan_blocks(document);
  require(!blocks.empty(), "the document has no block");
  return parse_block(document.substr(blocks[0].whole.begin, blocks[0].whole.size()), blocks[0]);
}

/// A block with this content.
inline ParsedBlock parse_equation(std::string_view content) {
  return parse_first_block("\\begin{equation}" + std::string(content) + "\\end{equation}");
}

/// One line per diagnostic: `E2001 [underlined text]`.
inline std::string diagnostics_text(const ParsedBlock& block) {
  std::string text;
  for (const Diagnostic& diagnostic : block.diagnostics) {
    if (!text.empty()) text += " ";
    text += code_name(diagnostic.code) + " [" + std::string(block.slice(diagnostic.where.span)) + "]";
  }
  return text;
}

}  // namespace texbrdf::test
