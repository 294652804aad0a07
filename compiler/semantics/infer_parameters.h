#pragma once

#include <optional>
#include <vector>

#include "semantics/type_body.h"

namespace texbrdf {

/// Node visits after which the search for types of parameters gives up.
inline constexpr uint64_t kMaxInferenceSteps = 1 << 22;
/// The same where instances are checked on the way.
inline constexpr uint64_t kMaxInstanceSteps = 1 << 16;

/// Types for the parameters of type Error in `known`, so that the body checks: the fewest vectors, of equally few the
/// leftmost. Nothing where no types do, or where the search would be too long.
std::optional<std::vector<Type>> infer_parameters(const DefinitionView& view, const ResolvedBody& body,
                                                  const std::vector<Type>& known, Calls calls);

}  // namespace texbrdf
