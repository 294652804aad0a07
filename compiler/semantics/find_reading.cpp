#include "semantics/find_reading.h"

#include "semantics/background.h"
#include "semantics/factors.h"
#include "semantics/possible_names.h"
#include "semantics/word_cuts.h"

namespace texbrdf {
namespace {

std::vector<NameId> defined_names(const ParsedBlock& block, const BlockNames& names, const NameTable& table) {
  std::vector<NameId> defined;
  for (const DefinitionSyntax& definition : block.definitions) {
    if (!is_background(block, definition, names, table)) defined.push_back(names.by_node[definition.name.value]);
  }
  return defined;
}

struct CutBlock {
  ParsedBlock block;
  BlockNames names;

  CutBlock(const ParsedBlock& plain, const std::vector<uint32_t>& cuts, NameTable& table)
      : block(parse_block(plain.source(), plain.source_extent(), std::pmr::get_default_resource(),
                          {.cuts = cuts, .factors = {}, .names = {}}, plain.expansion)),
        names(read_names(block, table)) {}
};

}  // namespace

FoundReading find_reading(const ParsedBlock& plain, const BlockNames& names, NameTable& table,
                          const KnownNames& known) {
  WordCuts words = find_word_cuts(plain, names, table, known);
  FoundReading found{.reading = {}, .cut_names = std::move(words.whole), .has_open_words = words.has_open_words};
  std::optional<CutBlock> cut;
  if (!words.cuts.empty()) cut.emplace(plain, words.cuts, table);
  if (cut && defined_names(cut->block, cut->names, table) != defined_names(plain, names, table)) cut.reset();
  if (cut) found.reading.cuts = std::move(words.cuts);
  const ParsedBlock& block = cut ? cut->block : plain;
  const BlockNames& read = cut ? cut->names : names;
  found.reading.factors = find_factors(block, read, table, known);
  found.reading.names = find_own_names(block, read, known);
  return found;
}

}  // namespace texbrdf
