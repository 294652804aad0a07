#include "diagnostics/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "source/internal_error.h"

namespace texbrdf {
namespace {

std::string snake_case(std::string_view upper_camel_case) {
  std::string name;
  for (const char c : upper_camel_case) {
    const bool upper = std::isupper(static_cast<unsigned char>(c)) != 0;
    if (upper && !name.empty()) name += '_';
    name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return name;
}

struct Catalogue {
  std::vector<std::string> names;
  std::vector<CatalogueEntry> entries;

  Catalogue() {
    entries = {
#define DIAGNOSTIC(number, name, severity, text, explanation) \
  CatalogueEntry{Code::name, #name, Severity::severity, text, explanation},
#include "diagnostics/catalogue.def"
#undef DIAGNOSTIC
    };
    std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.code < b.code; });
    names.reserve(entries.size());
    for (CatalogueEntry& entry : entries) entry.name = names.emplace_back(snake_case(entry.name));
  }
};

}  // namespace

const std::vector<CatalogueEntry>& catalogue() {
  static const Catalogue all;
  return all.entries;
}

const CatalogueEntry& catalogue_entry(Code code) {
  const auto& all = catalogue();
  const auto found =
      std::lower_bound(all.begin(), all.end(), code, [](const CatalogueEntry& e, Code c) { return e.code < c; });
  require(found != all.end() && found->code == code, "a code that is not in the catalogue");
  return *found;
}

std::string code_name(Code code) {
  return fmt::format("E{:04}", static_cast<uint16_t>(code));
}

Diagnostic make_diagnostic(Code code, Location where, std::vector<std::string> arguments) {
  return {code, catalogue_entry(code).severity, where, std::move(arguments), {}, {}};
}

std::string message(const Diagnostic& diagnostic) {
  const std::string_view text = catalogue_entry(diagnostic.code).text;
  std::string result;
  for (size_t i = 0; i < text.size(); ++i) {
    const bool placeholder =
        text[i] == '{' && i + 2 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9' && text[i + 2] == '}';
    if (!placeholder) {
      result += text[i];
      continue;
    }
    const auto index = static_cast<size_t>(text[i + 1] - '0');
    if (index < diagnostic.arguments.size()) result += diagnostic.arguments[index];
    i += 2;
  }
  return result;
}

std::string_view severity_name(Severity severity) {
  switch (severity) {
    case Severity::Error:
      return "error";
    case Severity::Warning:
      return "warning";
    case Severity::Information:
      return "information";
    case Severity::Hint:
      return "hint";
  }
  return "error";
}

}  // namespace texbrdf
