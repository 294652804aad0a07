#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "analysis/analysed_block.h"
#include "analysis/definition_record.h"
#include "analysis/directive.h"
#include "analysis/include.h"
#include "source/sequence.h"

namespace texbrdf {

/// Tells blocks apart and gives their order in the document. A block keeps its label while others come and go.
using BlockLabel = uint64_t;

/// A definition in its document.
struct PlacedDefinition {
  std::shared_ptr<const DefinitionRecord> record;
  bool in_force = false;
  bool is_used = false;  ///< something mentions its name
};

/// An error or a warning about a definition is a hint where the root does not need it.
inline bool is_demotable(const Diagnostic& diagnostic) {
  return diagnostic.severity < Severity::Information;
}

/// A block in its document. Where `analysed` is nullptr it was scanned, and nobody has read it yet.
struct PlacedBlock {
  BlockLabel label = 0;
  BlockExtent extent;  ///< `whole` is only good for its size
  std::shared_ptr<const AnalysedBlock> analysed;
  std::vector<PlacedDefinition> definitions;
  const MacroExpansion* expansion = nullptr;  ///< of `analysed`; here because many blocks are asked for it
  uint32_t reports = 0;                       ///< how much of it has to be reported, at most
  uint32_t demotable = 0;                     ///< errors and warnings about its definitions, at most
  uint32_t unused = 0;                        ///< definitions in force that nothing mentions
  uint32_t candidates = 0;                    ///< definitions in force whose name may be that of a BRDF
  uint32_t directives = 0;
  uint32_t integrals = 0;

  uint32_t restatements() const { return analysed ? static_cast<uint32_t>(analysed->parsed.restatements.size()) : 0; }
};

/// What prose says to texbrdf.
struct ProseRemarks {
  std::vector<Directive> directives;
  std::vector<Include> includes;
};

/// A stretch of the document: a block, or prose.
struct Segment {
  struct Measure {
    uint32_t bytes = 0;
    uint32_t reach = 0;  ///< the last byte that decided what the segments are
    uint32_t blocks = 0;
    uint32_t definitions = 0;
    uint32_t reports = 0;
    uint32_t demotable = 0;
    uint32_t without_definition = 0;  ///< blocks that define nothing, nor macros
    uint32_t unused = 0;
    uint32_t candidates = 0;
    uint32_t directives = 0;
    uint32_t includes = 0;
    uint32_t restatements = 0;
    uint32_t macros = 0;
    uint32_t integrals = 0;
    BlockLabel last_label = 0;
    friend Measure operator+(const Measure& a, const Measure& b) {
      return {a.bytes + b.bytes,
              std::max(a.reach, a.bytes + b.reach),
              a.blocks + b.blocks,
              a.definitions + b.definitions,
              a.reports + b.reports,
              a.demotable + b.demotable,
              a.without_definition + b.without_definition,
              a.unused + b.unused,
              a.candidates + b.candidates,
              a.directives + b.directives,
              a.includes + b.includes,
              a.restatements + b.restatements,
              a.macros + b.macros,
              a.integrals + b.integrals,
              std::max(a.last_label, b.last_label)};
    }
  };

  uint32_t size = 0;
  uint32_t reach = 0;
  std::shared_ptr<const PlacedBlock> block;     ///< nullptr for prose
  std::shared_ptr<const ProseRemarks> remarks;  ///< of prose that has some, else nullptr
  /// The macros that it defines; nullptr where it defines none. Their spans are relative to it.
  std::shared_ptr<const std::vector<MacroDefinition>> macros;

  Measure measure() const {
    Measure sum{.bytes = size, .reach = reach};
    if (remarks) {
      sum.directives = static_cast<uint32_t>(remarks->directives.size());
      sum.includes = static_cast<uint32_t>(remarks->includes.size());
    }
    if (macros) sum.macros = static_cast<uint32_t>(macros->size());
    if (!block) return sum;
    sum.blocks = 1;
    sum.definitions = static_cast<uint32_t>(block->definitions.size());
    sum.reports = block->reports;
    sum.demotable = block->demotable;
    sum.unused = block->unused;
    sum.candidates = block->candidates;
    sum.directives = block->directives;
    sum.restatements = block->restatements();
    sum.integrals = block->integrals;
    sum.without_definition = block->definitions.empty() && !macros ? 1 : 0;
    sum.last_label = block->label;
    return sum;
  }
};

using SegmentSequence = Sequence<Segment>;

inline std::span<const Directive> directives_of(const Segment& segment) {
  if (segment.block) return segment.block->analysed->directives;
  return segment.remarks ? std::span<const Directive>(segment.remarks->directives) : std::span<const Directive>();
}

/// A definition of a macro in its document.
struct PlacedMacro {
  const MacroDefinition* definition;
  uint32_t offset = 0;  ///< of its segment, in the project
};

/// All of a document, in order.
inline std::vector<PlacedMacro> macros_of(const SegmentSequence& segments) {
  std::vector<PlacedMacro> macros;
  segments.visit_where([](const Segment::Measure& sum) { return sum.macros > 0; },
                       [&](const Segment& segment, const Segment::Measure& before) {
                         for (const MacroDefinition& macro : *segment.macros) macros.push_back({&macro, before.bytes});
                         return true;
                       });
  return macros;
}

/// The block of the label; `item` is nullptr or another segment where there is none.
inline SegmentSequence::Place find_block(const SegmentSequence& segments, BlockLabel label) {
  SegmentSequence::Place place =
      segments.find([label](const Segment::Measure& sum) { return sum.last_label >= label; });
  if (place.item != nullptr && place.item->block->label != label) place.item = nullptr;
  return place;
}

}  // namespace texbrdf
