#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "analysis/snapshot.h"

namespace texbrdf::features {

/// A bracket that is open at the caret.
struct OpenBracket {
  enum class Role : uint8_t {
    Group,
    Call,         ///< `(` behind a name
    Function,     ///< of \sin …
    Extremum,     ///< of \max and \min
    Numerator,    ///< the groups of \frac
    Denominator,  //
    RootIndex,    ///< `[` and the group of \sqrt
    Radicand,     //
    Exponent,
    Subscript,  ///< `{` behind `_`
    Vec,        ///< `{` behind \vec
    Text,       ///< `{` behind \text or \mathrm, not closed
    Foreign,    ///< `{` behind a command of LaTeX that the language does not know
  };
  Role role = Role::Group;
  uint32_t token = 0;        ///< the opener
  uint32_t first_token = 0;  ///< where the name or command in front of it starts; the opener itself where none stands
  uint32_t commas = 0;       ///< before the caret, at its level

  /// Whether what stands in it is part of a name.
  bool is_part_of_name() const { return role == Role::Subscript || role == Role::Vec || role == Role::Text; }
};

/// Where somebody types inside a math block, read from the tokens in front of the caret alone: it holds in equations
/// that cannot be parsed yet.
struct Caret {
  BlockId block;
  uint32_t offset = 0;                ///< relative to the block, like all that follows
  Span typed;                         ///< the name or command up to the caret, from its first byte; may be empty
  Span word;                          ///< the last word of it: letters with their backslash, or what follows a brace
  uint32_t typed_token = 0;           ///< the first token that is not in front of `typed`
  std::vector<OpenBracket> brackets;  ///< open in front of `typed`, outermost first
  bool is_left_side = false;          ///< no `=` stands in front of it

  const OpenBracket* innermost() const { return brackets.empty() ? nullptr : &brackets.back(); }
};

/// Nothing outside of math blocks, in comments, in numbers, and in what the language does not read, such as \label{…}.
std::optional<Caret> find_caret(const Snapshot& snapshot, uint32_t offset);

/// A place in the content of a block, not in a comment.
struct MathPlace {
  BlockId block;
  uint32_t offset = 0;  ///< relative to the block
  uint32_t token = 0;   ///< the first token that does not end in front of it
};
std::optional<MathPlace> math_place(const Snapshot& snapshot, uint32_t offset);

/// All brackets that are open in front of a token, outermost first.
std::vector<OpenBracket> open_brackets(const ParsedBlock& block, uint32_t token);

}  // namespace texbrdf::features
