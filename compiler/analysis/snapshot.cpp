#include "analysis/snapshot.h"

#include <algorithm>
#include <unordered_set>

#include "analysis/control_word_places.h"
#include "analysis/equation_text.h"
#include "analysis/macro_places.h"
#include "analysis/needed_names.h"
#include "analysis/snapshot_state.h"
#include "source/characters.h"
#include "source/internal_error.h"

namespace texbrdf {
namespace {

Block public_block(const LocatedBlock& at) {
  // Both share the ownership of the whole analysed block.
  return {.offset = at.offset,
          .parsed = {at.block->analysed, &at.block->analysed->parsed},
          .names = {at.block->analysed, &at.block->analysed->names},
          .identity = at.block};
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

constexpr uint32_t kLongestMacroName = 100;

/// Of a use in an equation, or of a definition.
std::optional<MacroUse> macro_that_is_read(const Snapshot::State& state, const MacroPlaces& places,
                                           std::optional<BlockId> id, uint32_t offset) {
  if (std::optional<MacroUse> defined = places.defined_at(offset)) return defined;
  if (!id) return std::nullopt;
  const LocatedBlock block = state.locate(*id);
  const MacroExpansion* const expansion = block.block->expansion;
  const MacroUse* use = expansion != nullptr ? expansion->use_at(offset - block.offset) : nullptr;
  if (use == nullptr) return std::nullopt;
  const auto absolute = [&](Span span) { return Span{block.offset + span.begin, block.offset + span.end}; };
  return MacroUse{use->name, absolute(use->command), absolute(use->whole)};
}

/// `\x` around the offset, wherever it stands.
std::optional<MacroUse> macro_that_is_written(const Snapshot& snapshot, const MacroPlaces& known, uint32_t offset) {
  const SourceText& text = snapshot.text();
  const uint32_t first = offset - std::min(offset, kLongestMacroName);
  const std::string near = text.slice({first, std::min(text.size(), offset + kLongestMacroName)});
  const size_t backslash = near.rfind('\\', offset - first);
  if (backslash == std::string::npos) return std::nullopt;
  size_t end = backslash + 1;
  while (end < near.size() && is_letter(near[end])) ++end;
  const Span span{first + static_cast<uint32_t>(backslash), first + static_cast<uint32_t>(end)};
  const std::string name = near.substr(backslash + 1, end - backslash - 1);
  if (!span.touches(offset) || !known.definition_of(name)) return std::nullopt;
  const std::vector<Span> places = control_word_places(text.bytes(), snapshot.language(snapshot.file()), name);
  if (!std::ranges::binary_search(places, span)) return std::nullopt;
  return MacroUse{name, span, span};
}

}  // namespace

FileView::FileView(const ProjectText& text, const SegmentSequence& segments, FileId file)
    : file_(file), all_(segments.measure()) {
  const Span span = text.span(file);
  ++all_.bytes;  // an offset can be behind the last file
  const auto sum_before = [&](uint32_t at) {
    if (at == 0) return Segment::Measure{};
    return segments.find([at](const Segment::Measure& sum) { return sum.bytes > at; }).before;
  };
  before_ = sum_before(span.begin);
  const Segment::Measure behind = text.file_count() == 1 ? all_ : sum_before(span.end);
  blocks_ = behind.blocks - before_.blocks;
  definitions_ = behind.definitions - before_.definitions;
}

LocatedBlock Snapshot::State::locate(BlockId id) const {
  const uint32_t block = view.in_project(id);
  if (const AllBlocks* all = listed.load(std::memory_order_acquire)) return all->blocks[block];
  return located_at(segments.find([block](const Segment::Measure& sum) { return sum.blocks > block; }));
}

LocatedDefinition Snapshot::State::locate(DefinitionId id) const {
  const uint32_t definition = view.in_project(id);
  if (const AllBlocks* all = listed.load(std::memory_order_acquire)) {
    const LocatedBlock& block = all->blocks[all->block_of[definition]];
    return {block, id.value - block.first_definition};
  }
  const auto place = segments.find([definition](const Segment::Measure& sum) { return sum.definitions > definition; });
  return {located_at(place), definition - place.before.definitions};
}

LocatedBlock Snapshot::State::locate(BlockLabel label) const {
  return located_at(find_block(segments, label));
}

LocatedBlock Snapshot::State::located_at(const SegmentSequence::Place& place) const {
  require(place.item != nullptr && place.item->block != nullptr, "a block that is asked for exists");
  return located(*place.item, place.before);
}

std::optional<DefinitionKey> Snapshot::State::find(NameId name) const {
  if (name.value >= occurrences.size()) return std::nullopt;
  const Sequence<DefinitionKey>& definitions = occurrences.at(name.value).item->definitions;
  if (definitions.empty()) return std::nullopt;
  const DefinitionKey first = *definitions.at(0).item;
  return locate(first).placed().in_force ? std::optional(first) : std::nullopt;
}

Snapshot::Snapshot(std::shared_ptr<const State> state) : state_(std::move(state)) {}

const SourceText& Snapshot::text() const {
  return state_->text.file(state_->view.file());
}
FileId Snapshot::file() const {
  return state_->view.file();
}
uint32_t Snapshot::file_count() const {
  return state_->text.file_count();
}
TextLanguage Snapshot::language(FileId file) const {
  return state_->text.language(file);
}

const SourceText& Snapshot::text(FileId file) const {
  return state_->text.file(file);
}
FilePlace Snapshot::place(Span span) const {
  if (span.end <= text().size()) return {file(), span};
  const uint32_t begin = state_->view.offset_in_project(span.begin);
  const FileId id = state_->text.file_at(begin);
  const uint32_t relative = begin - state_->text.begin(id);
  return {id, {relative, relative + span.size()}};
}
SnapshotRange<Block, BlockId> Snapshot::blocks() const {
  return {*this, state_->view.blocks()};
}
SnapshotRange<Definition, DefinitionId> Snapshot::definitions() const {
  return {*this, state_->view.definitions()};
}
SnapshotRange<Definition, DefinitionId> Snapshot::all_definitions() const {
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
  const uint32_t at = state_->view.offset_in_project(std::min(offset, text().size()));
  const auto place = state_->segments.find([at](const Segment::Measure& sum) { return sum.bytes > at; });
  const bool starts_here = place.item != nullptr && place.item->block != nullptr;
  const uint32_t blocks = place.before.blocks + (starts_here ? 1 : 0) - state_->view.blocks_before();
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
uint64_t Snapshot::rereadings() const {
  return state_->rereadings;
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
      all->blocks.push_back(state_->located(segment, before));
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
  const LocatedBlock at = state_->locate(block);
  const Span source = at.parsed().in_source(relative);
  return {at.offset + source.begin, at.offset + source.end};
}

std::optional<MacroOccurrence> Snapshot::macro_at(uint32_t offset) const {
  if (state_->segments.measure().macros == 0) return std::nullopt;
  const MacroPlaces places(*state_);
  std::optional<MacroUse> found = macro_that_is_read(*state_, places, block_at(offset), offset);
  if (!found) found = macro_that_is_written(*this, places, offset);
  const std::optional<Location> name = found ? places.definition_of(found->name) : std::nullopt;
  if (!name) return std::nullopt;
  return MacroOccurrence{.name = found->name,
                         .span = found->command,
                         .whole = found->whole,
                         .definition = places.whole_definition_of(found->name)->span,
                         .definition_name = name->span};
}

std::vector<Span> Snapshot::places_of_macro(std::string_view name) const {
  std::vector<Span> places;
  for (uint32_t file = 0; file < file_count(); ++file) {
    const std::string text = state_->text.file(FileId{file}).bytes();
    const uint32_t first = state_->text.begin(FileId{file});
    for (const Span place : control_word_places(text, language(FileId{file}), name)) {
      const uint32_t begin = state_->view.offset(first + place.begin);
      places.push_back({begin, begin + place.size()});
    }
  }
  std::ranges::sort(places);
  return places;
}

std::vector<DocumentMacro> Snapshot::macros() const {
  if (state_->segments.measure().macros == 0) return {};
  return MacroPlaces(*state_).all();
}

std::string Snapshot::root_name() const {
  return state_->root.name_or_f();
}

std::vector<RootDirective> Snapshot::root_directives() const {
  std::vector<RootDirective> found;
  state_->segments.visit_where([](const Segment::Measure& sum) { return sum.directives > 0; },
                               [&](const Segment& segment, const Segment::Measure& before) {
                                 for (const Directive& directive : directives_of(segment)) {
                                   if (directive.kind != Directive::Kind::Root) continue;
                                   const Span name = directive.argument_span;
                                   const uint32_t begin = state_->view.offset(before.bytes + name.begin);
                                   found.push_back({root_of(directive), {begin, begin + name.size()}});
                                 }
                                 return true;
                               });
  return found;
}

bool Snapshot::is_ours() const {
  return state_->root.has_directives || !state_->root.name.empty();
}

bool Snapshot::holds_integrals() const {
  return state_->segments.measure().integrals > 0;
}

const std::vector<Diagnostic>& Snapshot::diagnostics() const {
  std::call_once(state_->diagnostics_once, [&] { state_->diagnostics = diagnostics({}); });
  return state_->diagnostics;
}

std::vector<Diagnostic> Snapshot::diagnostics(std::string_view root) const {
  std::call_once(state_->reports_once, [&] { state_->reports = document_reports(*state_); });
  return diagnostics_for_root(*state_, root.empty() ? root_name() : root);
}

bool Snapshot::has_errors() const {
  return std::ranges::any_of(diagnostics(), [](const Diagnostic& d) { return d.severity == Severity::Error; });
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

std::vector<RestatedDefinition> Snapshot::restatements(size_t most) const {
  std::vector<RestatedDefinition> found;
  const auto take = [&](const LocatedBlock& block) {
    if (allows(Code::RestatementDiffers, block.id)) return;
    for (const Restatement& restatement : block.parsed().restatements) {
      const LocatedDefinition definition{block, restatement.definition};
      if (!definition.placed().in_force || found.size() >= most) continue;
      found.push_back({definition.id(), restatement.body});
    }
  };
  state_->segments.visit_where([](const Segment::Measure& sum) { return sum.restatements > 0; },
                               [&](const Segment& segment, const Segment::Measure& before) {
                                 take(state_->located(segment, before));
                                 return found.size() < most;
                               });
  return found;
}

bool Snapshot::allows(Code code, BlockId block) const {
  const std::string name = code_name(code);
  const auto holds = [&](std::span<const Directive> directives) {
    return std::ranges::any_of(directives, [&](const Directive& directive) {
      return directive.kind == Directive::Kind::Allow && directive.argument == name;
    });
  };
  bool is_allowed = holds(state_->locate(block).block->analysed->directives);
  state_->segments.visit_where([](const Segment::Measure& sum) { return sum.directives > 0; },
                               [&](const Segment& segment, const Segment::Measure&) {
                                 is_allowed = is_allowed || (!segment.block && holds(directives_of(segment)));
                                 return !is_allowed;
                               });
  return is_allowed;
}

std::vector<NameId> Snapshot::needs_of(std::span<const NameId> names) const {
  std::vector<NameId> found;
  std::unordered_set<uint32_t> is_found;
  const auto add = [&](std::span<const NameId> some) {
    for (const NameId name : some) {
      if (is_found.insert(name.value).second) found.push_back(name);
    }
  };
  const auto at = [&](NameId name) -> std::optional<LocatedDefinition> {
    const std::optional<DefinitionKey> key = state_->find(name);
    return key ? std::optional(state_->locate(*key)) : std::nullopt;
  };
  for (const NameId name : names) {
    add({&name, 1});
    if (const auto definition = at(name)) add(argument_names(definition->checked()));
  }
  for (size_t i = 0; i < found.size(); ++i) {
    if (const auto definition = at(found[i])) {
      add(definition->at.block->analysed->mentions_of(definition->index_in_block));
    }
  }
  return found;
}

std::string Snapshot::equation(DefinitionId id) const {
  const LocatedDefinition definition = state_->locate(id);
  return one_line(definition.at.parsed(), definition.syntax().node);
}

}  // namespace texbrdf
