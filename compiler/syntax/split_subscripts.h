#pragma once

#include <memory_resource>
#include <vector>

#include "syntax/token.h"

namespace texbrdf {

/// `F_LF_V` as TeX reads it, where a run of letters cannot be one subscript because one of its own follows: its first
/// letter is the subscript, and its last takes the next.
void split_subscripts(std::pmr::vector<Token>& tokens);

}  // namespace texbrdf
