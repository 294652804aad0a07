#include "analysis/snapshot_facts.h"

namespace texbrdf {

CheckedRestatement Snapshot::check_restatement(const RestatedDefinition& restated) const {
  const BlockId block = definition(restated.definition).block;
  CheckedRestatement result{.syntax = syntax(restated.definition), .checked = {}, .asked = {}};
  result.syntax.node = result.syntax.body = restated.body;
  const SnapshotFacts facts(*this);
  result.checked = check_definition(parsed(block), result.syntax, names_of(block), names(), facts);
  result.asked = facts.asked();
  return result;
}

}  // namespace texbrdf
