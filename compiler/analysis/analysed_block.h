#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/directive.h"
#include "semantics/names.h"
#include "syntax/parsed_block.h"

namespace texbrdf {

/// All that is known of a block alone: it is kept across edits as long as the block's bytes stay.
struct AnalysedBlock {
  ParsedBlock parsed;
  BlockNames names;
  std::vector<Directive> directives;   ///< those right above it
  std::vector<NameId> mentions;        ///< of all definitions, one after the other
  std::vector<uint32_t> mention_ends;  ///< by definition

  std::span<const NameId> mentions_of(uint32_t definition) const {
    const uint32_t begin = definition == 0 ? 0 : mention_ends[definition - 1];
    return std::span(mentions).subspan(begin, mention_ends[definition] - begin);
  }
  NameId defined(uint32_t definition) const { return names.by_node[parsed.definitions[definition].name.value]; }
  /// True where scanning gave the same block again, wherever it now stands.
  bool is_same(std::string_view text, const BlockExtent& extent) const;
};

AnalysedBlock analyse_block(std::string_view text, const BlockExtent& extent, NameTable& table);

}  // namespace texbrdf
