#pragma once

#include <cstdint>
#include <vector>

#include "analysis/snapshot.h"

namespace texbrdf::features {

/// Every place in document order that names the same thing as the name at the offset.
std::vector<Span> references(const Snapshot& snapshot, uint32_t offset, bool include_declaration);

}  // namespace texbrdf::features
