#include "analysis/document.h"

#include <algorithm>

#include "analysis/snapshot_state.h"

namespace texbrdf {
namespace {

std::vector<Block> public_blocks(const std::vector<PlacedBlock>& placed) {
  std::vector<Block> blocks;
  blocks.reserve(placed.size());
  for (const PlacedBlock& block : placed) {
    // Both share the ownership of the whole analysed block.
    blocks.push_back({.offset = block.offset,
                      .parsed = {block.block, &block.block->parsed},
                      .names = {block.block, &block.block->names}});
  }
  return blocks;
}

std::vector<Definition> public_definitions(const DefinitionList& list, const CheckedDocument& checked) {
  std::vector<Definition> definitions;
  definitions.reserve(list.definitions.size());
  for (uint32_t i = 0; i < list.definitions.size(); ++i) {
    const ListedDefinition& definition = list.definitions[i];
    const std::shared_ptr<const DefinitionRecord>& record = checked.records[i];
    definitions.push_back({.block = BlockId{definition.block},
                           .index_in_block = definition.index_in_block,
                           .name = definition.name,
                           .in_force = list.find(definition.name) == i,
                           .checked = {record, &record->checked}});
  }
  return definitions;
}

std::shared_ptr<const Snapshot::State> analyse(std::shared_ptr<const SourceText> text,
                                               const std::shared_ptr<NameTable>& names,
                                               const Snapshot::State* earlier) {
  auto state = std::make_shared<Snapshot::State>();
  state->text = std::move(text);
  state->names = names;
  BlockList listed = list_blocks(state->text->bytes(), earlier ? earlier->placed : std::vector<PlacedBlock>{}, *names);
  state->placed = std::move(listed.blocks);
  state->list = list_definitions(state->placed, *names);
  if (earlier != nullptr) {
    const EarlierDocument before{earlier->list, earlier->checked};
    state->checked = check_document(state->placed, state->list, *names, &before);
  } else {
    state->checked = check_document(state->placed, state->list, *names, nullptr);
  }
  state->blocks = public_blocks(state->placed);
  state->definitions = public_definitions(state->list, state->checked);
  state->counters = {
      .blocks_scanned = listed.scanned, .blocks_parsed = listed.parsed, .definitions_checked = state->checked.checked};
  return state;
}

}  // namespace

struct Document::State {
  std::shared_ptr<const SourceText> text;
  std::shared_ptr<NameTable> names = std::make_shared<NameTable>();
  std::shared_ptr<const Snapshot::State> analysed;  // of the last snapshot; the text may be newer
  std::optional<Snapshot> snapshot;                 // of the text as it is
};

Document::Document(std::string text) : state_(std::make_unique<State>()) {
  set_text(std::move(text));
}
Document::~Document() = default;
Document::Document(Document&&) noexcept = default;
Document& Document::operator=(Document&&) noexcept = default;

void Document::replace(Span span, std::string_view replacement) {
  const std::string_view old = state_->text->bytes();
  const size_t begin = std::min<size_t>(span.begin, old.size());
  const size_t end = std::clamp<size_t>(span.end, begin, old.size());
  std::string text;
  text.reserve(old.size() - (end - begin) + replacement.size());
  text.append(old.substr(0, begin)).append(replacement).append(old.substr(end));
  set_text(std::move(text));
}

void Document::set_text(std::string text) {
  state_->text = std::make_shared<const SourceText>(std::move(text));
  state_->snapshot.reset();
}

const SourceText& Document::text() const {
  return *state_->text;
}

const Snapshot& Document::snapshot() {
  if (!state_->snapshot) {
    state_->analysed = analyse(state_->text, state_->names, state_->analysed.get());
    state_->snapshot.emplace(state_->analysed);
  }
  return *state_->snapshot;
}

}  // namespace texbrdf
