#pragma once

#include <mutex>

#include "analysis/block_list.h"
#include "analysis/check_document.h"
#include "analysis/definition_list.h"
#include "analysis/snapshot.h"

namespace texbrdf {

/// What a Snapshot shares with the Document for the next edit.
struct Snapshot::State {
  std::shared_ptr<const SourceText> text;
  std::shared_ptr<const NameTable> names;
  std::vector<PlacedBlock> placed;
  DefinitionList list;
  CheckedDocument checked;
  std::vector<Block> blocks;
  std::vector<Definition> definitions;
  Counters counters;

  mutable std::once_flag diagnostics_once;
  mutable std::vector<Diagnostic> diagnostics;  ///< without what concerns the root, in document order

  uint32_t first_definition(uint32_t block) const { return block == 0 ? 0 : list.block_ends[block - 1]; }
};

/// What is wrong with the document, whatever its root; the suggestions that need all its names included.
std::vector<Diagnostic> document_diagnostics(const Snapshot::State& state);
/// What is wrong with the root: it is missing, or no BRDF.
std::optional<Diagnostic> root_diagnostic(const Snapshot::State& state, std::string_view root);
/// True for ℝ and ℝ³, plain or as a function of two vectors.
bool is_brdf(const Signature& signature);

/// The text of a definition on one line: white space folded, without comments, labels and numbers.
std::string one_line(const ParsedBlock& block, const DefinitionSyntax& definition);

}  // namespace texbrdf
