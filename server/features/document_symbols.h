#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/snapshot.h"

namespace texbrdf::features {

enum class SymbolKind : uint8_t { Function, Variable, Parameter };

/// A definition, or a parameter of one. Its spans are relative to the block; the selection and the children's spans lie
/// one behind the other in `whole`.
struct Symbol {
  std::string_view name;  ///< points into the snapshot's names
  std::string type;
  SymbolKind kind = SymbolKind::Variable;
  BlockId block;
  Span whole;
  Span selection;  ///< the name
  std::vector<Symbol> children;
};

/// The definitions in document order, with their parameters.
std::vector<Symbol> document_symbols(const Snapshot& snapshot);
/// Those of one block.
std::vector<Symbol> block_symbols(const Snapshot& snapshot, BlockId block);

}  // namespace texbrdf::features
