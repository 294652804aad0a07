#include "semantics/known_names.h"

namespace texbrdf {
namespace {

/// As the left side has them: names, `\cos\theta`, expressions.
std::span<const NodeId> written_parameters(const ParsedBlock& block, const DefinitionSyntax& definition) {
  if (definition.left == definition.name) return {};
  return block.tree.children(definition.left).subspan(1);
}

}  // namespace

std::vector<NameId> parameter_names(const ParsedBlock& block, const DefinitionSyntax& definition,
                                    const BlockNames& names) {
  std::vector<NameId> found;
  for (const NodeId node : written_parameters(block, definition)) found.push_back(names.by_node[node.value]);
  return found;
}

SmallNameMap hidden_names(const ParsedBlock& block, const DefinitionSyntax& definition, const BlockNames& names) {
  SmallNameMap found;
  for (const NodeId node : written_parameters(block, definition)) {
    const NameId name = names.of_parameter(block, node);
    if (name.valid()) found.insert(name);
  }
  return found;
}

}  // namespace texbrdf
