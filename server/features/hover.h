#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "analysis/snapshot.h"
#include "features/describe.h"
#include "features/expression.h"

namespace texbrdf::features {

struct Hover {
  std::string text;
  Span span;                               ///< of the name, or of the expression
  std::optional<Expression> expression{};  ///< what has a value, but for parameters and conventions
};

/// What is known of the name at the offset: its type and equation, where it comes from, its value where it is constant;
/// or of the expression whose operator or bracket it is. Where nothing stands, of the name before it.
std::optional<Hover> hover(const Snapshot& snapshot, uint32_t offset, Markup markup);

}  // namespace texbrdf::features
