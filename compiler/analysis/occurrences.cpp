#include <algorithm>
#include <set>

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
  /// Each name means one thing: there is no parameter or index that hides one, and nothing that is not read.
  bool is_plain() const {
    return definition_.at.block->reports == 0 && named_.left == named_.name_node &&
           definition_.at.block->analysed->names.binders.empty();
  }

  /// It is the variable of a derivative by what the other one is.
  bool is_taken_by(const Referent& bound, const Referent& other) const {
    if (bound.kind != Referent::Kind::Bound) return false;
    const NodeId variable = definition_.checked().bound[bound.index].variable;
    return referent(variable) == other;
  }

  Occurrence occurrence(const NamePlace& place) const { return with_target(place, referent(place.node)); }

  Occurrence with_target(const NamePlace& place, const Referent& referent) const {
    Occurrence found = without_target(place, referent);
    if (found.node != named_.name_node && found.referent.kind == Referent::Kind::Definition) {
      const std::optional<DefinitionKey> target = state_.find(found.name);
      if (target) found.target = state_.locate(*target).id();
    }
    return found;
  }

  /// Of a reference the target is not looked up.
  Occurrence without_target(const NamePlace& place, const Referent& referent) const {
    Occurrence found;
    const MacroExpansion* const expansion = definition_.at.block->expansion;
    const Span source = expansion != nullptr ? expansion->in_source(place.span) : place.span;
    found.span = {definition_.at.offset + source.begin, definition_.at.offset + source.end};
    found.is_made = expansion != nullptr && !expansion->is_written(place.span);
    found.node = place.node;
    found.block = definition_.at.id;
    found.name = place.name;
    found.inside = definition_.id();
    found.referent = referent;
    const bool is_new = place.node == named_.name_node || referent.kind == Referent::Kind::Parameter;
    found.is_definition = place.node.value <= named_.left.value && is_new;
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

/// What stands in the further right sides of chains and means something beyond them: visits a place and its referent.
template <typename Visit>
void visit_restatements(const Snapshot& snapshot, const LocatedBlock& block, const Visit& visit) {
  const AnalysedBlock& analysed = *block.block->analysed;
  for (const Restatement& restatement : analysed.parsed.restatements) {
    const LocatedDefinition definition{block, restatement.definition};
    const CheckedRestatement again = snapshot.check_restatement({definition.id(), restatement.body});
    for (uint32_t node = definition.syntax().node.value + 1; node <= restatement.body.value; ++node) {
      const NameId name = analysed.names.by_node[node];
      const Referent& referent = again.checked.referents[node - again.syntax.first_node];
      const bool is_known = referent.kind == Referent::Kind::Definition || referent.kind == Referent::Kind::Parameter ||
                            referent.kind == Referent::Kind::Convention;
      const bool is_its_own = analysed.parsed.tree.node(NodeId{node}).first_token >=
                              analysed.parsed.tree.node(restatement.body).first_token;
      if (!name.valid() || !is_known || !is_its_own) continue;
      visit(definition, NamePlace{name, NodeId{node}, analysed.parsed.span(NodeId{node})}, referent);
    }
  }
}

bool mentions_again(const Segment& segment, NameId name) {
  const auto& names = segment.block->analysed->names.by_node;
  return std::ranges::find(names, name) != names.end();
}

/// A macro may write a name, or its argument, more than once.
void leave_out_repeated(std::vector<Occurrence>& occurrences) {
  std::set<Span> seen;
  std::erase_if(occurrences, [&](const Occurrence& occurrence) { return !seen.insert(occurrence.span).second; });
}

}  // namespace

std::optional<Occurrence> Snapshot::occurrence_at(uint32_t offset) const {
  const std::optional<BlockId> id = block_at(offset);
  if (!id) return std::nullopt;
  const LocatedBlock block = state_->locate(*id);
  const std::optional<uint32_t> relative = block.parsed().from_source(offset - block.offset);
  if (!relative) return std::nullopt;
  std::optional<Occurrence> touched;
  for (uint32_t i = 0; i < block.block->definitions.size(); ++i) {
    const LocatedDefinition definition{block, i};
    const NameReader reader(*state_, definition);
    for (const NamePlace& place : reader.places()) {
      if (!place.span.touches(*relative)) continue;
      const bool is_inside = *relative < place.span.end;
      Occurrence found = reader.occurrence(place);
      if (found.is_made) continue;
      if (is_inside || !touched) touched = found;
      if (is_inside) return touched;
    }
  }
  if (touched) return touched;
  visit_restatements(*this, block, [&](const LocatedDefinition& definition, const NamePlace& place, const Referent& r) {
    if (!place.span.touches(*relative) || (touched && *relative >= place.span.end)) return;
    const Occurrence found = NameReader(*state_, definition).with_target(place, r);
    if (!found.is_made) touched = found;
  });
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
      const Referent* const referent = is_the_same ? nullptr : &reader.referent(place.node);
      const bool is_meant =
          referent == nullptr || *referent == occurrence.referent || reader.is_taken_by(*referent, occurrence.referent);
      if (!is_meant) continue;
      found.push_back(reader.without_target(place, occurrence.referent));
      const bool is_reference = found.back().referent.kind == Referent::Kind::Definition;
      if (is_reference && !found.back().target.valid()) found.back().target = in_force;
    }
  };
  const auto read_restatements = [&](const LocatedBlock& block) {
    visit_restatements(
        *this, block, [&](const LocatedDefinition& definition, const NamePlace& place, const Referent& r) {
          const bool is_meant = place.name == occurrence.name && r == occurrence.referent;
          const bool is_inside = r.kind != Referent::Kind::Parameter || definition.id() == occurrence.inside;
          if (is_meant && is_inside) found.push_back(NameReader(*state_, definition).with_target(place, r));
        });
  };
  const bool is_bound = occurrence.referent.kind == Referent::Kind::Bound ||
                        occurrence.referent.kind == Referent::Kind::BoundAngle ||
                        occurrence.referent.kind == Referent::Kind::Indexed;
  if (is_bound || occurrence.referent.kind == Referent::Kind::Parameter) {
    const LocatedDefinition inside = state_->locate(occurrence.inside);
    read(inside);
    read_restatements(inside.at);
    if (state_->segments.measure().macros > 0) leave_out_repeated(found);
    return found;
  }
  visit_blocks_with(*this, *state_, occurrence.name, [&](const LocatedBlock& block) {
    for (uint32_t i = 0; i < block.block->definitions.size(); ++i) {
      const LocatedDefinition definition{block, i};
      if (may_hold(definition, occurrence.name)) read(definition);
    }
  });
  const size_t from_definitions = found.size();
  state_->segments.visit_where([](const Segment::Measure& sum) { return sum.restatements > 0; },
                               [&](const Segment& segment, const Segment::Measure& before) {
                                 if (mentions_again(segment, occurrence.name)) {
                                   read_restatements(state_->located(segment, before));
                                 }
                                 return true;
                               });
  if (found.size() > from_definitions) std::ranges::sort(found, {}, &Occurrence::span);
  // Unknown commands are in no list of names.
  if (found.empty() && occurrence.inside.valid()) read(state_->locate(occurrence.inside));
  if (state_->segments.measure().macros > 0) leave_out_repeated(found);
  return found;
}

}  // namespace texbrdf
