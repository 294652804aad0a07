#include "semantics/names.h"
#include "syntax/block_scanner.h"

namespace texbrdf {

std::optional<std::string> canonical_name(std::string_view spelling) {
  const std::string document = "\\begin{equation}" + std::string(spelling) + "=0\\end{equation}";
  const std::vector<BlockExtent> extents = scan_blocks(document);
  if (extents.size() != 1) return std::nullopt;
  const ParsedBlock block = parse_block(document, extents.front());
  if (!block.diagnostics.empty() || block.definitions.size() != 1) return std::nullopt;
  const DefinitionSyntax& definition = block.definitions.front();
  if (definition.left != definition.name) return std::nullopt;
  return canonical_form(read_name(block, definition.name));
}

}  // namespace texbrdf
