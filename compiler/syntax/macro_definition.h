#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "source/span.h"

namespace texbrdf {

/// How a document defines a macro.
enum class MacroForm : uint8_t {
  Command,   ///< \newcommand, \renewcommand
  Provided,  ///< \providecommand: only where nothing else defines the macro
  Plain,     ///< \def\x#1#2{…}
  Copy,      ///< \let\x=\y
  Operator,  ///< \DeclareMathOperator
  Brackets   ///< \DeclarePairedDelimiter
};

/// `\newcommand{\x}[2][d]{body}`, and what else defines a macro.
struct MacroDefinition {
  MacroForm form = MacroForm::Command;
  std::string name;                     ///< without the backslash
  uint32_t parameters = 0;              ///< at most 9
  std::optional<std::string> fallback;  ///< of the first argument, which may be left out then
  std::string body;                     ///< without comments; of a Copy what is copied
  Span span;                            ///< relative to what the definition stands in
  Span name_span;                       ///< likewise, with the backslash
};

/// What a text says behind the backslash of a word that defines macros.
struct MacroReading {
  std::optional<MacroDefinition> definition;  ///< nothing where it cannot be read
  uint32_t decided_at = 0;                    ///< no byte from here on was looked at
};

/// The word, which stands behind a backslash, defines macros.
bool defines_macros(std::string_view word);

/// Reads the definition whose backslash stands at `begin`; `behind_word` is where its word ends.
MacroReading read_macro_definition(std::string_view text, uint32_t begin, uint32_t behind_word);

/// All in a stretch of mathematics, in order.
std::vector<MacroDefinition> find_macro_definitions(std::string_view text, Span stretch);

}  // namespace texbrdf
