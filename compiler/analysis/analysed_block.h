#pragma once

#include <memory>
#include <memory_resource>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/directive.h"
#include "semantics/names.h"
#include "syntax/parsed_block.h"

namespace texbrdf {

/// What a definition says of names. Stands apart from its tree because it is read more often.
struct NamedDefinition {
  NameId name;
  uint32_t mentions_end = 0;  ///< in the list of its block; they begin behind those of the definition before
};

/// All that is known of a block alone: it is kept across edits as long as the block's bytes stay.
struct AnalysedBlock {
  /// Takes most of what it holds from `memory`, which has to outlive it.
  explicit AnalysedBlock(std::pmr::memory_resource* memory)
      : parsed(memory), names{std::pmr::vector<NameId>(memory)}, definitions(memory), mentions(memory) {}

  ParsedBlock parsed;
  BlockNames names;
  std::vector<Directive> directives;  ///< those right above it
  std::pmr::vector<NamedDefinition> definitions;
  std::pmr::vector<NameId> mentions;  ///< of all definitions, one after the other

  std::span<const NameId> mentions_of(uint32_t definition) const {
    const uint32_t begin = definition == 0 ? 0 : definitions[definition - 1].mentions_end;
    return std::span(mentions).subspan(begin, definitions[definition].mentions_end - begin);
  }
  NameId defined(uint32_t definition) const { return definitions[definition].name; }
  /// True where scanning gave the same block again, wherever it now stands.
  bool is_same(std::string_view text, const BlockExtent& extent) const;
};

AnalysedBlock analyse_block(std::string_view text, const BlockExtent& extent, NameTable& table,
                            std::pmr::memory_resource* memory);

}  // namespace texbrdf
