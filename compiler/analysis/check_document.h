#pragma once

#include <memory>
#include <vector>

#include "analysis/block_list.h"
#include "analysis/definition_list.h"
#include "analysis/definition_record.h"

namespace texbrdf {

/// Every definition of a document, checked.
struct CheckedDocument {
  std::vector<std::shared_ptr<const DefinitionRecord>> records;  ///< as DefinitionList::definitions
  std::vector<NameFact> facts;                                   ///< by NameId
  uint64_t checked = 0;                                          ///< definitions that were not taken over
};

/// What was known before the edit.
struct EarlierDocument {
  const DefinitionList& list;
  const CheckedDocument& checked;
};

/// Checks in dependency order. A definition whose block was taken over and whose facts all have the answers that they
/// had before is taken over too: what does not change its signature stops here.
CheckedDocument check_document(const std::vector<PlacedBlock>& blocks, const DefinitionList& list,
                               const NameTable& table, const EarlierDocument* earlier);

}  // namespace texbrdf
