#pragma once

#include <span>
#include <vector>

#include "semantics/body_view.h"

namespace texbrdf {

/// Types of a body under one reading of its parameters, by slot (the left side stays Error), and what is wrong.
struct TypedBody {
  std::vector<Type> types;
  std::vector<Diagnostic> diagnostics;
};

/// `leaves`: body.leaves, which may be given away where it is not needed again.
TypedBody type_body(const DefinitionView& view, const ResolvedBody& body, std::vector<Type> leaves,
                    std::span<const Type> parameters);

}  // namespace texbrdf
