#pragma once

#include "semantics/body_view.h"

namespace texbrdf {

/// Adds what is to be told of a sound definition where papers mean one thing or another by what it says: the reading
/// taken and the other, with a fix for each.
void tell_ambiguities(const DefinitionView& view, CheckedDefinition& checked);

}  // namespace texbrdf
