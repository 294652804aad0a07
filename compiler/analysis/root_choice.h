#pragma once

#include "analysis/engine_state.h"

namespace texbrdf {

/// The definition that `% texbrdf: root = NAME` names. Else, of `f`, `f_r`, `f_s`, `f_{…}`, the one that depends on a
/// direction and that no other such definition uses; where none depends on any, the one that nothing else uses. A
/// function `\rho` of directions comes last.
void choose_root(EngineState& state);

/// By its name, and what it is.
bool is_root_candidate(const NameTraits& traits, const CheckedDefinition& checked);

}  // namespace texbrdf
