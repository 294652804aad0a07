#pragma once

#include <cstdint>
#include <vector>

#include "analysis/snapshot.h"

namespace texbrdf::features {

struct Highlight {
  Span span;
  bool writes = false;  ///< it is defined or declared there, elsewhere it is used
};

/// Every place in document order that names the same thing as the name at the offset.
std::vector<Highlight> document_highlights(const Snapshot& snapshot, uint32_t offset);

}  // namespace texbrdf::features
