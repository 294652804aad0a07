#pragma once

#include <memory_resource>
#include <string_view>
#include <vector>

#include "syntax/token.h"

namespace texbrdf {

/// Finds the `dx` that belongs to each integral, and the fractions that are derivatives, `\frac{d}{dx}`: gives their
/// tokens the kinds that say so, and makes two tokens of the word `dx`. `tokens` are closed by an End token.
void mark_differentials(std::string_view text, std::pmr::vector<Token>& tokens);

}  // namespace texbrdf
