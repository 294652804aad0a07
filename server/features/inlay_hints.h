#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "analysis/snapshot.h"

namespace texbrdf::features {

struct InlayHintOptions {
  bool definition_types = true;
  bool parameter_types = true;
  bool constant_values = true;
};

struct InlayHint {
  enum class Kind : uint8_t { Type, Value };
  uint32_t offset = 0;  ///< it is shown in front of this byte
  Kind kind = Kind::Type;
  std::string label;
};

/// Types that are not written and values that are not plain to see, for definitions in the range:
/// `a: ℝ = 1/4 = 0.25`, `g(x: ℝ³): ℝ = …`. In the order of the text.
std::vector<InlayHint> inlay_hints(const Snapshot& snapshot, Span range, const InlayHintOptions& options);

}  // namespace texbrdf::features
