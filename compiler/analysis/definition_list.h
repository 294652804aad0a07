#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "analysis/block_list.h"
#include "semantics/dependency_order.h"

namespace texbrdf {

inline constexpr uint32_t kNoDefinition = UINT32_MAX;

struct ListedDefinition {
  uint32_t block = 0;
  uint32_t index_in_block = 0;
  NameId name;
};

/// The definitions of a document, who of two is in force, and in which order to check them.
struct DefinitionList {
  std::vector<ListedDefinition> definitions;  ///< in document order
  std::vector<uint32_t> block_ends;           ///< by block: the definitions up to its end
  std::vector<uint32_t> in_force;             ///< by NameId: index of the definition, or kNoDefinition
  DependencyOrder order;

  uint32_t find(NameId name) const { return name.value < in_force.size() ? in_force[name.value] : kNoDefinition; }
};

/// The first definition of a name is in force; one of a constant of the convention never is.
DefinitionList list_definitions(std::span<const PlacedBlock> blocks, const NameTable& table);

}  // namespace texbrdf
