#pragma once

#include <cstdint>
#include <string_view>

#include "source/span.h"

namespace texbrdf {

/// Kinds of tokens, from token_kind.def.
enum class TokenKind : uint8_t {
#define TOKEN_KIND(name, description) name,
#include "syntax/token_kind.def"
#undef TOKEN_KIND
};

std::string_view token_kind_name(TokenKind kind);
/// It may separate definitions, or is misplaced; inside an expression it means nothing.
constexpr bool is_layout(TokenKind kind) {
  return kind == TokenKind::Ampersand || kind == TokenKind::Gap || kind == TokenKind::NewRow;
}

/// It makes a name of its own of the name behind it.
constexpr bool is_decoration(TokenKind kind) {
  return kind == TokenKind::Vec || kind == TokenKind::Accent;
}

/// The commands that the language knows, from commands.def: \sin, \max, \frac …
enum class Command : uint8_t {
  None,
#define COMMAND(name, spelling, category) name,
#include "syntax/commands.def"
#undef COMMAND
};

struct Token {
  TokenKind kind;
  Command command = Command::None;  ///< of a command of the language, else None
  Span span;                        ///< relative to the block
};

}  // namespace texbrdf
