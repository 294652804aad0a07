#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace texbrdf::scene {

enum class GlslTokenKind : uint8_t {
  Word,     ///< name, type or keyword
  Number,   ///< with its suffix
  Sign,     ///< one character
  Blank,    ///< spaces, line breaks, comments
  Unclosed  ///< a comment that does not end
};

struct GlslToken {
  GlslTokenKind kind = GlslTokenKind::Blank;
  std::string_view text;
  uint32_t line = 0;          ///< of its begin, counted from 0
  bool in_directive = false;  ///< on a line that begins with #, the # included
};

/// The whole code: its tokens, one after the other, have all of its bytes.
std::vector<GlslToken> lex_glsl(std::string_view code);

}  // namespace texbrdf::scene
