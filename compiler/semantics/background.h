#pragma once

#include "semantics/names.h"
#include "syntax/parsed_block.h"

namespace texbrdf {

/// What looks like a definition and states something else: that a function is symmetric, `f_r(l, v) = f_r(v, l)`; what
/// a BRDF is as a quotient of differentials, `f_r = dL_o / dE_i`; in prose, at which angle something holds, `$\theta_i
/// = 0$`; what the cosine of a known angle is as an integral; what a call of a known function amounts to,
/// `\text{dot}(r, v) = \cos\alpha`.
bool is_background(const ParsedBlock& block, const DefinitionSyntax& definition, const BlockNames& names,
                   const NameTable& table);

}  // namespace texbrdf
