#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "source/span.h"

namespace texbrdf {

enum class Severity : uint8_t { Error, Warning, Information, Hint };

/// Every kind of message, from catalogue.def. Codes are stable and never used again.
enum class Code : uint16_t {
#define DIAGNOSTIC(number, name, severity, text, explanation) name = number,
#include "diagnostics/catalogue.def"
#undef DIAGNOSTIC
};

struct CatalogueEntry {
  Code code;
  std::string_view name;  ///< snake case of the enumerator, as the docs' anchor
  Severity severity;
  std::string_view text;         ///< `{0}`, `{1}` … stand for Diagnostic::arguments
  std::string_view explanation;  ///< one paragraph for docs/diagnostics.md
};

/// All entries, by number.
const std::vector<CatalogueEntry>& catalogue();
const CatalogueEntry& catalogue_entry(Code code);
/// "E2001": the letter is the stage-independent "E", four digits.
std::string code_name(Code code);

struct Edit {
  Location where;
  std::string replacement;
};

/// One way to mend the problem; several fixes of a diagnostic are alternatives.
struct Fix {
  std::string title;
  std::vector<Edit> edits;
};

struct RelatedPlace {
  Location where;
  std::string message;
};

/// The text is formed at the edge (see `message`), so that fixes and docs can use the data.
struct Diagnostic {
  Code code;
  Severity severity;
  Location where;
  std::vector<std::string> arguments;
  std::vector<RelatedPlace> related;
  std::vector<Fix> fixes;
};

/// With the severity of the catalogue.
Diagnostic make_diagnostic(Code code, Location where, std::vector<std::string> arguments = {});
std::string message(const Diagnostic& diagnostic);
std::string_view severity_name(Severity severity);  // "error", "warning", "information", "hint"

}  // namespace texbrdf
