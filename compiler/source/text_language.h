#pragma once

#include <cstdint>
#include <string_view>

namespace texbrdf {

/// What the prose around mathematics is written in. It is told with a text, never guessed from it.
enum class TextLanguage : uint8_t { Latex, Markdown };

/// By the extension: .md, .markdown, .mdx, .Rmd and .qmd are Markdown.
TextLanguage language_of_path(std::string_view path);

}  // namespace texbrdf
