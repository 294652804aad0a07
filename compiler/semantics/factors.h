#pragma once

#include <functional>
#include <vector>

#include "semantics/names.h"
#include "syntax/parsed_block.h"

namespace texbrdf {

/// What a document makes of a name: a name of the convention without a definition is Absent.
enum class NameKind : uint8_t { Absent, Value, Function };

/// The `(` behind names that open a factor and no arguments, as parse_block takes them: the name is a parameter, a
/// value of the document or of the convention, and one expression stands in the brackets. So `a(b + c)` is a product,
/// and a call exactly where `a` is defined with parameters, or nowhere.
std::vector<uint32_t> find_factors(const ParsedBlock& block, const BlockNames& names, const NameTable& table,
                                   const std::function<NameKind(NameId)>& kind_of);

}  // namespace texbrdf
