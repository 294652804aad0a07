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

/// A name in a block.
struct NamePlace {
  NameId name;
  NodeId node;
  Span span;  ///< relative to the block
};

/// What a definition says of names. Stands apart from its tree because it is read more often.
struct NamedDefinition {
  NameId name;
  NodeId name_node;
  NodeId left;                ///< the Name, or the Signature around it
  uint32_t mentions_end = 0;  ///< in the lists of its block; they begin behind those of the definition before
  uint32_t places_end = 0;
};

/// By definition of a block, the names that it depends on although it does not mention them; empty where there are
/// none.
using ImpliedMentions = std::vector<std::vector<NameId>>;
/// Which of several definitions of a name is meant: the first of the best standing; of values the last.
enum class Standing : uint8_t {
  Display,
  Prose,  ///< inline; or a left side that may state a property of the function, `f(a - b) = …`
  Value,  ///< inline, numbers: a text that discusses special values gives its own last
  Limit,  ///< inline, 0 or 1: what text says of a parameter before it gives its value, as `$e = 0$ is a mirror`
};

/// All that is known of a block alone: it is kept across edits as long as the block's bytes stay.
struct AnalysedBlock {
  /// Takes most of what it holds from `memory`, and what is read of many blocks from `dense`; both have to outlive it.
  AnalysedBlock(std::pmr::memory_resource* memory, std::pmr::memory_resource* dense)
      : definitions(dense), places(dense), mentions(dense), names{std::pmr::vector<NameId>(memory)}, parsed(memory) {}

  std::pmr::vector<NamedDefinition> definitions;
  std::pmr::vector<NamePlace> places;  ///< of all names in definitions, in order of nodes
  std::pmr::vector<NameId> mentions;   ///< of all definitions, one after the other, with those that are implied; then
                                       ///< what chains name once more
  ImpliedMentions implied;             ///< as analyse_block was told
  BlockNames names;
  std::vector<Directive> directives;  ///< those right above it
  ParsedBlock parsed;

  std::span<const NameId> mentions_of(uint32_t definition) const {
    const uint32_t begin = definition == 0 ? 0 : definitions[definition - 1].mentions_end;
    return std::span(mentions).subspan(begin, definitions[definition].mentions_end - begin);
  }
  std::span<const NamePlace> places_of(uint32_t definition) const {
    const uint32_t begin = definition == 0 ? 0 : definitions[definition - 1].places_end;
    return std::span(places).subspan(begin, definitions[definition].places_end - begin);
  }
  NameId defined(uint32_t definition) const { return definitions[definition].name; }
  Standing standing(uint32_t definition) const;
  /// True where scanning gave the same block again, wherever it now stands, and its macros stand for the same.
  bool is_same(std::string_view text, const BlockExtent& extent, const MacroExpansion* expansion) const;
};

AnalysedBlock analyse_block(std::string_view text, const BlockExtent& extent, NameTable& table,
                            std::pmr::memory_resource* memory, std::pmr::memory_resource* dense,
                            std::shared_ptr<const MacroExpansion> expansion, Reading reading = {},
                            ImpliedMentions implied = {});

}  // namespace texbrdf
