#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "analysis/snapshot.h"
#include "features/describe.h"

namespace texbrdf::features {

struct Hover {
  std::string text;
  Span span;  ///< of the name
};

/// What is known of the name at the offset: its type and equation, where it comes from, its value where it is constant.
std::optional<Hover> hover(const Snapshot& snapshot, uint32_t offset, Markup markup);

}  // namespace texbrdf::features
