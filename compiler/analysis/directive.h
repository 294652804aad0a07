#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "syntax/block_scanner.h"

namespace texbrdf {

/// What a comment `% texbrdf: …`, in Markdown `<!-- texbrdf: … -->`, asks for.
struct Directive {
  enum class Kind : uint8_t {
    Root,    ///< root = NAME: the definition that is the BRDF
    Ignore,  ///< above a block: it is not read
    Allow,   ///< allow CODE: this code is not reported, in the block below or, elsewhere, in the whole document
    Unknown
  };
  Kind kind = Kind::Unknown;
  std::string argument;  ///< the name as it is written, or the code
  Span span;             ///< of the comment, relative to its part of the document
  Span argument_span;    ///< likewise
};

/// The canonical name of a Root.
std::string root_of(const Directive& directive);

/// `comment` is from the `%` to the end of the line, or from `<!--` to `-->`; nothing where it does not begin with
/// `% texbrdf:`, `<!-- texbrdf:`.
std::optional<Directive> read_directive(std::string_view comment, Span span);

/// Those right above a block: in front of its \begin.
std::vector<Directive> directives_above(std::string_view block_text, const BlockExtent& extent);

}  // namespace texbrdf
