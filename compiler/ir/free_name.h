#pragma once

#include <cstdint>

#include "ir/graph.h"

namespace texbrdf::ir {

/// A name for a definition that is joined to a document's for one program only, a different one for each index. No
/// document has so many names; how many it has is not asked, because other threads may add some meanwhile.
constexpr NameId free_name(uint32_t index) {
  return {kFirstInstance - 1 - index};
}

}  // namespace texbrdf::ir
