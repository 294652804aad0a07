#pragma once

#include <vector>

#include "semantics/known_names.h"

namespace texbrdf {

/// Reading::factors: the name is a parameter, a
/// value of the document or of the convention, and one expression stands in the brackets. So `a(b + c)` is a product,
/// and a call exactly where `a` is defined with parameters, or nowhere. Also the `^` of `a^2(x)`, where `a` is a
/// function.
std::vector<uint32_t> find_factors(const ParsedBlock& block, const BlockNames& names, const NameTable& table,
                                   const KnownNames& known);

}  // namespace texbrdf
