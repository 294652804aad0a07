#pragma once

#include <string_view>

#include "syntax/token.h"

namespace texbrdf {

/// What a backslash followed by letters means to the lexer.
enum class WordMeaning : uint8_t {
  Name,               ///< no word of the language: a Greek letter, or a name of the document
  Command,            ///< an operator or function of commands.def
  Nothing,            ///< no token
  NothingWithGroup,   ///< no token, nor the brace group behind it
  NothingWithBraces,  ///< no token, nor the braces of the group behind it
  NothingWithScript,  ///< no token, nor the label below or above the group behind it
  Text,               ///< with the brace group or the letter behind it one token
  TextDeclaration,    ///< `{\rm …}` is one token; by itself none
  Vec,
  Accent,
  Token,           ///< one token of the entry's kind
  Delimiter,       ///< \left: no token, nor the `.` behind it
  Environment,     ///< \begin
  EnvironmentEnd,  ///< \end
  Verbatim,        ///< \verb
};

struct ControlWord {
  std::string_view spelling;  ///< without the backslash
  WordMeaning meaning = WordMeaning::Name;
  TokenKind kind = TokenKind::Macro;  ///< of its token, where it makes one by itself
  Command command = Command::None;
};

/// The entry of the word, or one that says Name.
const ControlWord& find_control_word(std::string_view letters);

/// The command that is written so behind a backslash, or None.
Command find_command(std::string_view letters);
/// "frac" of Command::Frac; empty for None.
std::string_view command_spelling(Command command);
/// Whether the word is reserved without its backslash, and read as the command where that makes sense.
constexpr bool reserves_word(Command command) {
  return command != Command::None && command != Command::Det;
}
/// `\log_2`: a subscript is the base of a logarithm.
constexpr bool takes_base(Command function) {
  return function == Command::Log || function == Command::Ln;
}
/// The function that `^{-1}` makes of one; None where the language has none.
Command inverse_of(Command function);
/// \sin, \cos and \tan, of which papers give the value to say what the angle is.
bool is_trigonometric(Command function);

}  // namespace texbrdf
