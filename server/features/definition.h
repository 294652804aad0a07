#pragma once

#include <cstdint>
#include <optional>

#include "analysis/snapshot.h"

namespace texbrdf::features {

/// From the name at a place to where it is declared.
struct DefinitionLink {
  Span origin;  ///< the name that was asked about
  Span whole;   ///< the equation that declares it
  Span name;    ///< the name in that equation
};

/// Nothing where no name stands, or one that the document does not declare.
std::optional<DefinitionLink> definition_at(const Snapshot& snapshot, uint32_t offset);

}  // namespace texbrdf::features
