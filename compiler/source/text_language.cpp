#include "source/text_language.h"

#include <algorithm>
#include <array>

namespace texbrdf {
namespace {

constexpr auto kMarkdownExtensions =
    std::to_array<std::string_view>({".md", ".markdown", ".mdx", ".Rmd", ".rmd", ".qmd"});

}  // namespace

TextLanguage language_of_path(std::string_view path) {
  const bool is_markdown = std::ranges::any_of(
      kMarkdownExtensions, [path](std::string_view extension) { return path.ends_with(extension); });
  return is_markdown ? TextLanguage::Markdown : TextLanguage::Latex;
}

}  // namespace texbrdf
