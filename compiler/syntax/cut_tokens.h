#pragma once

#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

#include "syntax/token.h"

namespace texbrdf {

/// Cuts words in two, or more, at the bytes of Reading::cuts; a `\Delta` that begins at one is a name by itself.
void cut_tokens(std::pmr::vector<Token>& tokens, std::span<const uint32_t> cuts);

}  // namespace texbrdf
