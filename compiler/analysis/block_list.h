#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "analysis/analysed_block.h"

namespace texbrdf {

struct PlacedBlock {
  uint32_t offset = 0;  ///< absolute, of its first byte
  std::shared_ptr<const AnalysedBlock> block;
  uint32_t old_index = UINT32_MAX;  ///< its place in the list it was taken over from
};

struct BlockList {
  std::vector<PlacedBlock> blocks;
  uint64_t scanned = 0;
  uint64_t parsed = 0;
};

/// The blocks of a document. What stands unchanged in `old`, at the same place from either end or anywhere between, is
/// taken over without lexing.
BlockList list_blocks(std::string_view document, const std::vector<PlacedBlock>& old, NameTable& table);

}  // namespace texbrdf
