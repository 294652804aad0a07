#include "analysis/snapshot_facts.h"

#include "semantics/implied_parameters.h"
#include "semantics/known_names.h"

namespace texbrdf {
namespace {

NameFact fact_of(const Snapshot& snapshot, DefinitionId id) {
  const Definition definition = snapshot.definition(id);
  NameFact fact;
  fact.kind = NameFact::Kind::Defined;
  fact.signature = definition.checked->signature;
  fact.parameters = fact.signature.has_implied_parameters
                        ? names_of_parameters(*definition.checked)
                        : parameter_names(snapshot.parsed(definition.block), snapshot.syntax(id),
                                          snapshot.names_of(definition.block));
  return fact;
}

}  // namespace

const NameFact& SnapshotFacts::fact(NameId name) const {
  const auto [place, is_new] = known_.try_emplace(name);
  if (is_new) {
    if (const auto id = snapshot_.find(name)) place->second = fact_of(snapshot_, *id);
  }
  return place->second;
}

std::vector<NameId> SnapshotFacts::asked() const {
  std::vector<NameId> names;
  for (const auto& [name, fact] : known_) names.push_back(name);
  return names;
}

std::optional<DefinitionView> SnapshotFacts::definition(NameId function) const {
  const std::optional<DefinitionId> id = snapshot_.find(function);
  if (!id) return std::nullopt;
  const BlockId block = snapshot_.definition(*id).block;
  return DefinitionView{snapshot_.parsed(block), snapshot_.syntax(*id), snapshot_.names_of(block), snapshot_.names(),
                        *this};
}

}  // namespace texbrdf
