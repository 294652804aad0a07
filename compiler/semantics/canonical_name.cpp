#include "semantics/names.h"
#include "syntax/block_scanner.h"

namespace texbrdf {

namespace {

/// A label is part of a name in front of arguments only.
bool ends_with_label(std::string_view spelling) {
  return spelling.ends_with(")}") && spelling.find("^{(") != std::string_view::npos;
}

}  // namespace

std::optional<Name> name_spelled(std::string_view spelling) {
  const bool has_label = ends_with_label(spelling);
  const std::string left = std::string(spelling) + (has_label ? "(x)" : "");
  const std::string document = "\\begin{equation}" + left + "=0\\end{equation}";
  const std::vector<BlockExtent> extents = scan_blocks(document);
  if (extents.size() != 1) return std::nullopt;
  const ParsedBlock block = parse_block(document, extents.front());
  if (!block.diagnostics.empty() || block.definitions.size() != 1) return std::nullopt;
  const DefinitionSyntax& definition = block.definitions.front();
  if ((definition.left != definition.name) != has_label) return std::nullopt;
  const bool is_name_alone =
      block.tree.node(definition.node).first_token == block.tree.node(definition.left).first_token;
  if (!is_name_alone) return std::nullopt;
  return read_name(block, definition.name);
}

std::optional<std::string> canonical_name(std::string_view spelling) {
  const std::optional<Name> name = name_spelled(spelling);
  return name ? std::optional(canonical_form(*name)) : std::nullopt;
}

}  // namespace texbrdf
