#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <tuple>

#include "analysis/engine_state.h"
#include "analysis/include.h"
#include "analysis/snapshot.h"
#include "analysis/suggestions.h"

namespace texbrdf {

/// A block and where it stands.
struct LocatedBlock {
  const PlacedBlock* block = nullptr;
  BlockId id;
  uint32_t offset = 0;
  uint32_t first_definition = 0;

  const ParsedBlock& parsed() const { return block->analysed->parsed; }
};

/// A definition and where it stands.
struct LocatedDefinition {
  LocatedBlock at;
  uint32_t index_in_block = 0;

  const PlacedDefinition& placed() const { return at.block->definitions[index_in_block]; }
  const CheckedDefinition& checked() const { return placed().record->checked; }
  const DefinitionSyntax& syntax() const { return at.parsed().definitions[index_in_block]; }
  NameId name() const { return at.block->analysed->defined(index_in_block); }
  DefinitionId id() const { return {at.first_definition + index_in_block}; }
  Location name_place() const { return {.file = {}, .block = at.id, .span = at.parsed().span(syntax().name)}; }
};

/// A project as it is seen from one of its files: that file comes first, and those before it come behind all others. So
/// the offsets, blocks and definitions of the file count from 0.
class FileView {
 public:
  FileView() = default;
  FileView(const ProjectText& text, const SegmentSequence& segments, FileId file);

  FileId file() const { return file_; }
  uint32_t blocks() const { return blocks_; }            ///< in the file
  uint32_t definitions() const { return definitions_; }  ///< in the file

  uint32_t offset(uint32_t in_project) const { return turned(in_project, before_.bytes, all_.bytes); }
  BlockId block(uint32_t in_project) const { return {turned(in_project, before_.blocks, all_.blocks)}; }
  DefinitionId definition(uint32_t in_project) const {
    return {turned(in_project, before_.definitions, all_.definitions)};
  }
  uint32_t offset_in_project(uint32_t seen) const { return turned_back(seen, before_.bytes, all_.bytes); }
  uint32_t in_project(BlockId seen) const { return turned_back(seen.value, before_.blocks, all_.blocks); }
  uint32_t in_project(DefinitionId seen) const {
    return turned_back(seen.value, before_.definitions, all_.definitions);
  }
  uint32_t blocks_before() const { return before_.blocks; }

 private:
  static uint32_t turned(uint32_t value, uint32_t before, uint32_t all) {
    return value >= before ? value - before : value + (all - before);
  }
  static uint32_t turned_back(uint32_t value, uint32_t before, uint32_t all) {
    return value < all - before ? value + before : value - (all - before);
  }

  FileId file_;
  uint32_t blocks_ = 0;
  uint32_t definitions_ = 0;
  Segment::Measure before_;  // of the files before
  Segment::Measure all_;
};

/// A diagnostic and the name whose definition it is about, if any.
struct Report {
  Diagnostic diagnostic;
  NameId about;

  /// A hint where the root does not need the definition.
  bool is_demotable() const { return about.valid() && texbrdf::is_demotable(diagnostic); }
};

/// Orders diagnostics by where they stand, and those of one place so that all views of a project agree.
inline auto place_and_content(const Diagnostic& diagnostic) {
  return std::tie(diagnostic.where, diagnostic.code, diagnostic.arguments);
}

/// What a Snapshot holds: the part of the engine's state that does not change any more.
struct Snapshot::State {
  ProjectText text;
  SegmentSequence segments;
  FileView view;
  std::shared_ptr<const std::vector<IncludeProblem>> include_problems;
  std::shared_ptr<const NameTable> names;
  OccurrencesByName occurrences;
  bool lists_users = false;
  uint64_t rereadings = 0;
  std::shared_ptr<const std::vector<Cycle>> cycles;
  std::shared_ptr<NameSuggestions> suggestions;
  Counters counters;

  DirectionalNames directional;
  RootChoice root;
  std::shared_ptr<const std::vector<bool>> needed;  ///< as EngineState::needed

  mutable std::once_flag reports_once;
  mutable std::vector<Report> reports;  ///< without what concerns the root, in document order
  mutable std::once_flag diagnostics_once;
  mutable std::vector<Diagnostic> diagnostics;  ///< with it

  /// All blocks, and by DefinitionId the block: listed when all are gone through.
  struct AllBlocks {
    std::vector<LocatedBlock> blocks;
    std::vector<uint32_t> block_of;
  };
  mutable std::once_flag all_once;
  mutable std::unique_ptr<const AllBlocks> all_blocks;
  mutable std::atomic<const AllBlocks*> listed = nullptr;

  /// Where `before` is the sum of all before the segment of a block.
  LocatedBlock located(const Segment& segment, const Segment::Measure& before) const {
    return {&*segment.block, view.block(before.blocks), view.offset(before.bytes),
            view.definition(before.definitions).value};
  }
  LocatedBlock located_at(const SegmentSequence::Place& place) const;
  LocatedBlock locate(BlockId id) const;
  LocatedDefinition locate(DefinitionId id) const;
  LocatedBlock locate(BlockLabel label) const;
  LocatedDefinition locate(const DefinitionKey& key) const { return {locate(key.block), key.index_in_block}; }
  /// The definition in force.
  std::optional<DefinitionKey> find(NameId name) const;
};

/// What is wrong with the document, whatever its root; the suggestions that need all its names included.
std::vector<Report> document_reports(const Snapshot::State& state);
/// All that is wrong when `root` (canonical) is the BRDF.
std::vector<Diagnostic> diagnostics_for_root(const Snapshot::State& state, std::string_view root);
/// True for ℝ and ℝ³, plain or as a function of two vectors.
bool is_brdf(const Signature& signature);

}  // namespace texbrdf
