#pragma once

#include <string_view>
#include <vector>

#include "source/span.h"
#include "source/text_language.h"

namespace texbrdf {

/// Where `\word` stands in a text, prose included, in order; `word` is without the backslash. Not in comments and
/// verbatim text.
std::vector<Span> control_word_places(std::string_view text, TextLanguage language, std::string_view word);

}  // namespace texbrdf
