#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/snapshot.h"
#include "source/source_text.h"

namespace texbrdf::lsp {

/// The document symbols that were answered last, as JSON with a comma behind each, and which part of it is which
/// block's. An edit changes few.
struct SymbolCache {
  struct Run {
    const void* block = nullptr;  ///< its identity
    Position begin;
    uint32_t offset = 0;  ///< into `json`
    uint32_t size = 0;
  };

  std::optional<Snapshot> snapshot;  ///< keeps the identities good
  std::vector<Run> runs;             ///< by block
  std::string json;
};

}  // namespace texbrdf::lsp
