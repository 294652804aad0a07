#pragma once

#include <cstdint>
#include <vector>

#include "semantics/known_names.h"

namespace texbrdf {

/// Where the runs of letters of a block are products.
struct WordCuts {
  std::vector<uint32_t> cuts;  ///< Reading::cuts
  std::vector<NameId> whole;   ///< the names that are cut, as they would be without
  /// Some name is neither known nor cut: it may be when others are defined.
  bool has_open_words = false;
};

/// A run of letters that is no name of the document is a product of names that are, the longest first. `block` is read
/// without cuts. A name that means something by itself is never cut, and none is cut into names that are not defined.
WordCuts find_word_cuts(const ParsedBlock& block, const BlockNames& names, const NameTable& table,
                        const KnownNames& known);

}  // namespace texbrdf
