#include "analysis/snapshot.h"

#include <algorithm>

#include "analysis/snapshot_state.h"
#include "source/internal_error.h"

namespace texbrdf {
namespace {

LocatedBlock located(const Segment& segment, const Segment::Measure& before) {
  return {segment.block.get(), BlockId{before.blocks}, before.bytes, before.definitions};
}

LocatedBlock located(const SegmentSequence::Place& place) {
  require(place.item != nullptr && place.item->block != nullptr, "a block that is asked for exists");
  return located(*place.item, place.before);
}

Block public_block(const LocatedBlock& at) {
  // Both share the ownership of the whole analysed block.
  return {.offset = at.offset,
          .parsed = {at.block->analysed, &at.block->analysed->parsed},
          .names = {at.block->analysed, &at.block->analysed->names}};
}

Definition public_definition(const LocatedDefinition& at) {
  const PlacedDefinition& placed = at.placed();
  return {.block = at.at.id,
          .index_in_block = at.index_in_block,
          .name = at.name(),
          .in_force = placed.in_force,
          .is_used = placed.is_used,
          .checked = {placed.record, &placed.record->checked}};
}

}  // namespace

LocatedBlock Snapshot::State::locate(BlockId id) const {
  if (const AllBlocks* all = listed.load(std::memory_order_acquire)) return all->blocks[id.value];
  return located(segments.find([id](const Segment::Measure& sum) { return sum.blocks > id.value; }));
}

LocatedDefinition Snapshot::State::locate(DefinitionId id) const {
  if (const AllBlocks* all = listed.load(std::memory_order_acquire)) {
    const LocatedBlock& block = all->blocks[all->block_of[id.value]];
    return {block, id.value - block.first_definition};
  }
  const auto place = segments.find([id](const Segment::Measure& sum) { return sum.definitions > id.value; });
  return {located(place), id.value - place.before.definitions};
}

LocatedBlock Snapshot::State::locate(BlockLabel label) const {
  return located(find_block(segments, label));
}

std::optional<DefinitionKey> Snapshot::State::find(NameId name) const {
  if (name.value >= name_index.size()) return std::nullopt;
  const Sequence<DefinitionKey>& definitions = name_index.at(name.value).item->definitions;
  if (definitions.empty()) return std::nullopt;
  const DefinitionKey first = *definitions.at(0).item;
  return locate(first).placed().in_force ? std::optional(first) : std::nullopt;
}

Snapshot::Snapshot(std::shared_ptr<const State> state) : state_(std::move(state)) {}

const SourceText& Snapshot::text() const {
  return state_->text;
}
SnapshotRange<Block, BlockId> Snapshot::blocks() const {
  return {*this, state_->segments.measure().blocks};
}
SnapshotRange<Definition, DefinitionId> Snapshot::definitions() const {
  return {*this, state_->segments.measure().definitions};
}
Block Snapshot::block(BlockId id) const {
  return public_block(state_->locate(id));
}
Definition Snapshot::definition(DefinitionId id) const {
  return public_definition(state_->locate(id));
}
const DefinitionSyntax& Snapshot::syntax(DefinitionId id) const {
  return state_->locate(id).syntax();
}
const ParsedBlock& Snapshot::parsed(BlockId id) const {
  return state_->locate(id).parsed();
}
const BlockNames& Snapshot::names_of(BlockId id) const {
  return state_->locate(id).block->analysed->names;
}
std::optional<BlockId> Snapshot::block_at(uint32_t offset) const {
  const auto place = state_->segments.find([offset](const Segment::Measure& sum) { return sum.bytes > offset; });
  const bool starts_here = place.item != nullptr && place.item->block != nullptr;
  const uint32_t blocks = place.before.blocks + (starts_here ? 1 : 0);
  if (blocks == 0) return std::nullopt;
  return BlockId{blocks - 1};
}
DefinitionRange Snapshot::definitions_of(BlockId id) const {
  const LocatedBlock at = state_->locate(id);
  return {{at.first_definition}, {at.first_definition + static_cast<uint32_t>(at.block->definitions.size())}};
}
const NameTable& Snapshot::names() const {
  return *state_->names;
}
std::shared_ptr<const NameTable> Snapshot::shared_names() const {
  return state_->names;
}
Counters Snapshot::counters() const {
  return state_->counters;
}

void Snapshot::list_all() const {
  std::call_once(state_->all_once, [&] {
    auto all = std::make_unique<State::AllBlocks>();
    all->blocks.reserve(state_->segments.measure().blocks);
    all->block_of.reserve(state_->segments.measure().definitions);
    state_->segments.visit_from(0, [&](const Segment& segment, const Segment::Measure& before) {
      if (!segment.block) return true;
      all->block_of.resize(all->block_of.size() + segment.block->definitions.size(), before.blocks);
      all->blocks.push_back(located(segment, before));
      return true;
    });
    state_->all_blocks = std::move(all);
    state_->listed.store(state_->all_blocks.get(), std::memory_order_release);
  });
}

Span Snapshot::absolute(const Location& location) const {
  return absolute(location.block, location.span);
}
Span Snapshot::absolute(BlockId block, Span relative) const {
  if (block.value >= state_->segments.measure().blocks) return relative;
  const uint32_t offset = state_->locate(block).offset;
  return {offset + relative.begin, offset + relative.end};
}

std::string Snapshot::root_name() const {
  return state_->root.name.empty() ? "f" : state_->root.name;
}

bool Snapshot::is_ours() const {
  return state_->root.has_directives || !state_->root.name.empty();
}

std::vector<Diagnostic> Snapshot::diagnostics(std::string_view root) const {
  std::call_once(state_->reports_once, [&] { state_->reports = document_reports(*state_); });
  return diagnostics_for_root(*state_, root.empty() ? root_name() : root);
}

bool Snapshot::has_errors() const {
  const std::vector<Diagnostic> all = diagnostics();
  return std::ranges::any_of(all, [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

std::optional<DefinitionId> Snapshot::find(std::string_view canonical) const {
  const NameId name = state_->names->find(canonical);
  return name.valid() ? find(name) : std::nullopt;
}

std::optional<DefinitionId> Snapshot::find(NameId name) const {
  const std::optional<DefinitionKey> key = state_->find(name);
  if (!key) return std::nullopt;
  return state_->locate(*key).id();
}

std::string Snapshot::equation(DefinitionId id) const {
  const LocatedDefinition definition = state_->locate(id);
  return one_line(definition.at.parsed(), definition.syntax());
}

}  // namespace texbrdf
