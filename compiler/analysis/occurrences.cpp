#include <algorithm>

#include "analysis/snapshot.h"
#include "analysis/snapshot_state.h"

namespace texbrdf {
namespace {

/// Reads the names of one definition.
class NameReader {
 public:
  NameReader(const Snapshot& snapshot, DefinitionId id)
      : snapshot_(snapshot), id_(id), definition_(snapshot.definition(id)), syntax_(snapshot.syntax(id)) {}

  uint32_t begin() const { return syntax_.first_node; }
  uint32_t end() const { return syntax_.node.value; }

  NameId name(uint32_t node) const { return snapshot_.blocks()[definition_.block.value].names->by_node[node]; }
  const Referent& referent(uint32_t node) const { return definition_.checked->referents[node - syntax_.first_node]; }
  Span relative(uint32_t node) const { return snapshot_.parsed(definition_.block).span(NodeId{node}); }

  Occurrence occurrence(uint32_t node) const {
    Occurrence found;
    found.span = snapshot_.absolute(definition_.block, relative(node));
    found.node = NodeId{node};
    found.block = definition_.block;
    found.name = name(node);
    found.inside = id_;
    found.referent = referent(node);
    found.is_definition = node <= syntax_.left.value;
    if (found.node == syntax_.name) {
      found.target = id_;
    } else if (found.referent.kind == Referent::Kind::Definition) {
      found.target = snapshot_.find(found.name).value_or(DefinitionId{});
    }
    return found;
  }

 private:
  const Snapshot& snapshot_;
  DefinitionId id_;
  const Definition& definition_;
  const DefinitionSyntax& syntax_;
};

bool may_hold(const Snapshot& snapshot, DefinitionId id, const Occurrence& wanted) {
  if (wanted.referent.kind == Referent::Kind::Parameter) return id == wanted.inside;
  const Definition& definition = snapshot.definition(id);
  return definition.name == wanted.name ||
         std::ranges::find(definition.checked->mentioned, wanted.name) != definition.checked->mentioned.end();
}

// A name that refers to nothing is the same as any other that is spelled so.
bool is_same_thing(const Occurrence& wanted, NameId name, const Referent& referent) {
  return name == wanted.name && referent == wanted.referent;
}

}  // namespace

std::optional<Occurrence> Snapshot::occurrence_at(uint32_t offset) const {
  const std::optional<BlockId> block = block_at(offset);
  if (!block) return std::nullopt;
  const uint32_t relative = offset - state_->blocks[block->value].offset;
  const DefinitionRange definitions = definitions_of(*block);
  std::optional<Occurrence> touched;
  for (uint32_t id = definitions.first.value; id < definitions.end.value; ++id) {
    const NameReader reader(*this, DefinitionId{id});
    for (uint32_t node = reader.begin(); node < reader.end(); ++node) {
      if (!reader.name(node).valid() || !reader.relative(node).touches(relative)) continue;
      const bool is_inside = relative < reader.relative(node).end;
      if (is_inside || !touched) touched = reader.occurrence(node);
      if (is_inside) return touched;
    }
  }
  return touched;
}

std::vector<Occurrence> Snapshot::occurrences_of(const Occurrence& occurrence) const {
  std::vector<Occurrence> found;
  for (uint32_t id = 0; id < state_->definitions.size(); ++id) {
    if (!may_hold(*this, DefinitionId{id}, occurrence)) continue;
    const NameReader reader(*this, DefinitionId{id});
    for (uint32_t node = reader.begin(); node < reader.end(); ++node) {
      if (!reader.name(node).valid()) continue;
      if (is_same_thing(occurrence, reader.name(node), reader.referent(node))) found.push_back(reader.occurrence(node));
    }
  }
  return found;
}

}  // namespace texbrdf
