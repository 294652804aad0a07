#include "analysis/definition_list.h"

namespace texbrdf {
namespace {

bool can_be_defined(const NameTraits& traits) {
  return !traits.convention || !convention_constant(*traits.convention);
}

void list_block(const AnalysedBlock& block, uint32_t index, const NameTable& table, DefinitionList& list) {
  const auto count = static_cast<uint32_t>(block.parsed.definitions.size());
  for (uint32_t i = 0; i < count; ++i) {
    const NameId name = block.names.by_node[block.parsed.definitions[i].name.value];
    uint32_t& in_force = list.in_force[name.value];
    if (in_force == kNoDefinition && can_be_defined(table.traits(name))) {
      in_force = static_cast<uint32_t>(list.definitions.size());
    }
    list.definitions.push_back({index, i, name});
  }
}

AdjacencyLists edges_of(const DefinitionList& list, std::span<const PlacedBlock> blocks) {
  AdjacencyLists edges;
  edges.starts.reserve(list.definitions.size() + 1);
  for (const ListedDefinition& definition : list.definitions) {
    for (NameId name : blocks[definition.block].block->mentions_of(definition.index_in_block)) {
      if (const uint32_t target = list.find(name); target != kNoDefinition) edges.targets.push_back(target);
    }
    edges.close_list();
  }
  return edges;
}

}  // namespace

DefinitionList list_definitions(std::span<const PlacedBlock> blocks, const NameTable& table) {
  DefinitionList list;
  list.in_force.assign(table.size(), kNoDefinition);
  list.definitions.reserve(blocks.size());
  list.block_ends.reserve(blocks.size());
  for (uint32_t i = 0; i < blocks.size(); ++i) {
    list_block(*blocks[i].block, i, table, list);
    list.block_ends.push_back(static_cast<uint32_t>(list.definitions.size()));
  }
  list.order = dependency_order(edges_of(list, blocks));
  return list;
}

}  // namespace texbrdf
