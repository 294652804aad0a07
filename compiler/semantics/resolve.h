#pragma once

#include "semantics/body_view.h"

namespace texbrdf {

/// Finds out what the names of a definition are, and reports what can be said without types: undefined and reserved
/// names, unknown commands, calls of what is no function, functions used as values, and faults of the left side.
/// Fills `checked.parameters` (types only where the spelling gives them).
ResolvedBody resolve_names(const DefinitionView& view, CheckedDefinition& checked);

}  // namespace texbrdf
