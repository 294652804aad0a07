#include <algorithm>

#include "analysis/snapshot.h"
#include "analysis/snapshot_state.h"

namespace texbrdf {
namespace {

/// Reads the names of one definition. Many are read when a name is looked for, so little is touched.
class NameReader {
 public:
  NameReader(const Snapshot::State& state, const LocatedDefinition& definition)
      : state_(state),
        definition_(definition),
        named_(definition.at.block->analysed->definitions[definition.index_in_block]) {}

  std::span<const NamePlace> places() const {
    return definition_.at.block->analysed->places_of(definition_.index_in_block);
  }
  const Referent& referent(NodeId node) const {
    return definition_.checked().referents[node.value - definition_.syntax().first_node];
  }
  /// Each name means one thing: there is no parameter that hides one, and nothing that is not read.
  bool is_plain() const { return definition_.at.block->reports == 0 && named_.left == named_.name_node; }

  Occurrence occurrence(const NamePlace& place) const {
    Occurrence found = without_target(place, referent(place.node));
    if (found.node != named_.name_node && found.referent.kind == Referent::Kind::Definition) {
      const std::optional<DefinitionKey> target = state_.find(found.name);
      if (target) found.target = state_.locate(*target).id();
    }
    return found;
  }

  /// Of a reference the target is not looked up.
  Occurrence without_target(const NamePlace& place, const Referent& referent) const {
    Occurrence found;
    found.span = {definition_.at.offset + place.span.begin, definition_.at.offset + place.span.end};
    found.node = place.node;
    found.block = definition_.at.id;
    found.name = place.name;
    found.inside = definition_.id();
    found.referent = referent;
    found.is_definition = place.node.value <= named_.left.value;
    if (found.node == named_.name_node) found.target = definition_.id();
    return found;
  }

 private:
  const Snapshot::State& state_;
  const LocatedDefinition& definition_;
  const NamedDefinition& named_;
};

// A name that stands in one block of so many, or more, is not looked for block by block.
constexpr uint32_t kFewest = 16;

// Blocks lie all over the memory: waiting for one after the other would take half of the time that a search takes.
constexpr size_t kAhead = 8;

/// Has what is read of later blocks brought near: first the block, then its names.
void fetch_behind(std::span<const LocatedBlock> blocks, size_t at) {
  if (at + 2 * kAhead < blocks.size()) __builtin_prefetch(blocks[at + 2 * kAhead].block->analysed.get());
  if (at + kAhead >= blocks.size()) return;
  const AnalysedBlock& next = *blocks[at + kAhead].block->analysed;
  __builtin_prefetch(next.definitions.data());
  __builtin_prefetch(next.places.data());
}

/// Visits the blocks that may hold a name, in document order.
template <typename Visit>
void visit_blocks_with(const Snapshot& snapshot, const Snapshot::State& state, NameId name, const Visit& visit) {
  const NameOccurrences& occurrences = *state.occurrences.at(name.value).item;
  const bool is_in_most = occurrences.users.size() > state.segments.measure().blocks / kFewest;
  if (!state.lists_users || is_in_most) {
    snapshot.list_all();
    const std::vector<LocatedBlock>& blocks = state.all_blocks->blocks;
    for (size_t i = 0; i < blocks.size(); ++i) {
      fetch_behind(blocks, i);
      visit(blocks[i]);
    }
    return;
  }
  std::vector<BlockLabel> labels;
  occurrences.definitions.visit_from(0, [&](const DefinitionKey& key, const DefinitionKey&) {
    labels.push_back(key.block);
    return true;
  });
  occurrences.users.visit_from(0, [&](const UserKey& key, const UserKey&) {
    labels.push_back(key.block);
    return true;
  });
  std::ranges::sort(labels);
  const auto repeated = std::ranges::unique(labels);
  labels.erase(repeated.begin(), repeated.end());
  for (BlockLabel label : labels) visit(state.locate(label));
}

/// False where the name stands only in what is not read, as behind an unknown command.
bool may_hold(const LocatedDefinition& definition, NameId name) {
  if (definition.at.block->reports == 0) return true;
  const std::span<const NameId> mentions = definition.at.block->analysed->mentions_of(definition.index_in_block);
  return definition.name() == name || std::ranges::find(mentions, name) != mentions.end();
}

}  // namespace

std::optional<Occurrence> Snapshot::occurrence_at(uint32_t offset) const {
  const std::optional<BlockId> id = block_at(offset);
  if (!id) return std::nullopt;
  const LocatedBlock block = state_->locate(*id);
  const uint32_t relative = offset - block.offset;
  std::optional<Occurrence> touched;
  for (uint32_t i = 0; i < block.block->definitions.size(); ++i) {
    const LocatedDefinition definition{block, i};
    const NameReader reader(*state_, definition);
    for (const NamePlace& place : reader.places()) {
      if (!place.span.touches(relative)) continue;
      const bool is_inside = relative < place.span.end;
      if (is_inside || !touched) touched = reader.occurrence(place);
      if (is_inside) return touched;
    }
  }
  return touched;
}

std::vector<Occurrence> Snapshot::occurrences_of(const Occurrence& occurrence) const {
  const DefinitionId in_force = find(occurrence.name).value_or(DefinitionId{});
  std::vector<Occurrence> found;
  if (occurrence.name.value >= state_->occurrences.size()) return found;
  const bool is_what_names_mean = occurrence.referent.kind == Referent::Kind::Definition && in_force.valid();
  // A name that refers to nothing is the same as any other that is spelled so.
  const auto read = [&](const LocatedDefinition& definition) {
    const NameReader reader(*state_, definition);
    const bool is_the_same = is_what_names_mean && reader.is_plain();
    for (const NamePlace& place : reader.places()) {
      if (place.name != occurrence.name) continue;
      if (!is_the_same && reader.referent(place.node) != occurrence.referent) continue;
      found.push_back(reader.without_target(place, occurrence.referent));
      const bool is_reference = found.back().referent.kind == Referent::Kind::Definition;
      if (is_reference && !found.back().target.valid()) found.back().target = in_force;
    }
  };
  if (occurrence.referent.kind == Referent::Kind::Parameter) {
    read(state_->locate(occurrence.inside));
    return found;
  }
  visit_blocks_with(*this, *state_, occurrence.name, [&](const LocatedBlock& block) {
    for (uint32_t i = 0; i < block.block->definitions.size(); ++i) {
      const LocatedDefinition definition{block, i};
      if (may_hold(definition, occurrence.name)) read(definition);
    }
  });
  // Unknown commands are in no list of names.
  if (found.empty() && occurrence.inside.valid()) read(state_->locate(occurrence.inside));
  return found;
}

}  // namespace texbrdf
