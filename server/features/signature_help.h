#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/snapshot.h"
#include "features/describe.h"

namespace texbrdf::features {

/// The call that somebody is writing.
struct SignatureHelp {
  std::string label;             ///< `g(x: ℝ, \omega_i: ℝ³): ℝ`
  std::vector<Span> parameters;  ///< in bytes of the label
  uint32_t active = 0;           ///< the parameter of the caret; behind the last where there are too many arguments
  std::string documentation;
};

/// Of the innermost call around the offset, whether or not its equation can be read. Nothing where there is none, or
/// its function is unknown.
std::optional<SignatureHelp> signature_help(const Snapshot& snapshot, uint32_t offset, Markup markup);

}  // namespace texbrdf::features
