#include "analysis/snapshot.h"

#include <algorithm>

#include "analysis/snapshot_state.h"

namespace texbrdf {

Snapshot::Snapshot(std::shared_ptr<const State> state) : state_(std::move(state)) {}

const SourceText& Snapshot::text() const {
  return *state_->text;
}
std::span<const Block> Snapshot::blocks() const {
  return state_->blocks;
}
std::span<const Definition> Snapshot::definitions() const {
  return state_->definitions;
}
const Definition& Snapshot::definition(DefinitionId id) const {
  return state_->definitions[id.value];
}
const DefinitionSyntax& Snapshot::syntax(DefinitionId id) const {
  const Definition& found = definition(id);
  return parsed(found.block).definitions[found.index_in_block];
}
const ParsedBlock& Snapshot::parsed(BlockId id) const {
  return *state_->blocks[id.value].parsed;
}
std::optional<BlockId> Snapshot::block_at(uint32_t offset) const {
  const auto behind = std::ranges::upper_bound(state_->blocks, offset, {}, &Block::offset);
  if (behind == state_->blocks.begin()) return std::nullopt;
  return BlockId{static_cast<uint32_t>(behind - state_->blocks.begin() - 1)};
}
DefinitionRange Snapshot::definitions_of(BlockId id) const {
  return {{state_->first_definition(id.value)}, {state_->list.block_ends[id.value]}};
}
const NameTable& Snapshot::names() const {
  return *state_->names;
}
Counters Snapshot::counters() const {
  return state_->counters;
}

Span Snapshot::absolute(const Location& location) const {
  return absolute(location.block, location.span);
}
Span Snapshot::absolute(BlockId block, Span relative) const {
  if (block.value >= state_->blocks.size()) return relative;
  const uint32_t offset = state_->blocks[block.value].offset;
  return {offset + relative.begin, offset + relative.end};
}

std::vector<Diagnostic> Snapshot::diagnostics(std::string_view root_name) const {
  std::call_once(state_->diagnostics_once, [&] { state_->diagnostics = document_diagnostics(*state_); });
  std::vector<Diagnostic> all = state_->diagnostics;
  if (std::optional<Diagnostic> root = root_diagnostic(*state_, root_name)) {
    const auto behind = std::ranges::upper_bound(all, root->where, {}, &Diagnostic::where);
    all.insert(behind, std::move(*root));
  }
  return all;
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
  const uint32_t index = state_->list.find(name);
  if (index == kNoDefinition) return std::nullopt;
  return DefinitionId{index};
}

std::string Snapshot::equation(DefinitionId id) const {
  return one_line(parsed(definition(id).block), syntax(id));
}

}  // namespace texbrdf
