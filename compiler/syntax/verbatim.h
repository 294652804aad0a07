#pragma once

#include <cstddef>
#include <string_view>

namespace texbrdf {

/// Where the text of `\verb|…|` or `\verb*|…|` ends, whose letters end at `behind_word`: behind the second delimiter,
/// or with its line.
size_t end_of_verb(std::string_view text, size_t behind_word);

/// Nothing in it is read: `verbatim`, `lstlisting`, `comment`.
bool is_raw_environment(std::string_view name);

}  // namespace texbrdf
