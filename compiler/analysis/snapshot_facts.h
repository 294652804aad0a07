#pragma once

#include <map>

#include "analysis/snapshot.h"
#include "semantics/instance_facts.h"

namespace texbrdf {

/// What a definition may know of the rest of a snapshot's document.
class SnapshotFacts final : public InstanceFacts {
 public:
  explicit SnapshotFacts(const Snapshot& snapshot) : snapshot_(snapshot) {}

  const NameFact& fact(NameId name) const override;

  /// The names that were asked for.
  std::vector<NameId> asked() const;

 private:
  std::optional<DefinitionView> definition(NameId function) const override;
  InstancesOfFunction& known_instances(NameId function) const override { return instances_[function]; }

  const Snapshot& snapshot_;
  mutable std::map<NameId, NameFact> known_;
  mutable std::map<NameId, InstancesOfFunction> instances_;
};

}  // namespace texbrdf
