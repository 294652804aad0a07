#pragma once

#include <vector>

#include "semantics/known_names.h"

namespace texbrdf {

/// How a block is read where the document makes of its names what is known.
struct FoundReading {
  Reading reading;
  std::vector<NameId> cut_names;  ///< runs of letters that are products, as they would be called without
  bool has_open_words = false;    ///< some name is neither known nor cut: it may be when others are defined
};

/// Of the block `plain`, which is read by itself, with its names. Words are cut first, then factors and own names found
/// in what that gives. Words that would make the block define other names stay whole.
FoundReading find_reading(const ParsedBlock& plain, const BlockNames& names, NameTable& table, const KnownNames& known);

}  // namespace texbrdf
