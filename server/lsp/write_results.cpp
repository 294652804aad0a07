#include "lsp/write_results.h"

#include <fmt/format.h>

namespace texbrdf::lsp {
namespace {

void write_position(JsonWriter& out, Position position) {
  out.begin_object();
  out.member("line", position.line);
  out.member("character", position.column);
  out.end_object();
}

void write_range(JsonWriter& out, std::string_view key, Range range) {
  out.key(key);
  out.begin_object();
  out.key("start");
  write_position(out, range.start);
  out.key("end");
  write_position(out, range.end);
  out.end_object();
}

int severity_number(Severity severity) {
  switch (severity) {
    case Severity::Error:
      return 1;
    case Severity::Warning:
      return 2;
    case Severity::Information:
      return 3;
    case Severity::Hint:
      return 4;
  }
  return 1;
}

int symbol_kind_number(features::SymbolKind kind) {
  constexpr int kFunction = 12;
  constexpr int kVariable = 13;
  constexpr int kTypeParameter = 26;
  switch (kind) {
    case features::SymbolKind::Function:
      return kFunction;
    case features::SymbolKind::Variable:
      return kVariable;
    case features::SymbolKind::Parameter:
      return kTypeParameter;
  }
  return kVariable;
}

void write_symbol(JsonWriter& out, Positions& positions, const features::Symbol& symbol) {
  out.begin_object();
  out.member("name", symbol.name);
  out.member("detail", symbol.type);
  out.member("kind", symbol_kind_number(symbol.kind));
  write_range(out, "range", positions.range(symbol.whole));
  write_range(out, "selectionRange", positions.range(symbol.selection));
  if (!symbol.children.empty()) {
    out.key("children");
    write_symbols(out, positions, symbol.children);
  }
  out.end_object();
}

void write_flat_symbol(JsonWriter& out, Positions& positions, std::string_view uri, const features::Symbol& symbol,
                       std::string_view container) {
  out.begin_object();
  out.member("name", symbol.name);
  out.member("kind", symbol_kind_number(symbol.kind));
  out.key("location");
  write_location(out, positions, uri, symbol.whole);
  if (!container.empty()) out.member("containerName", container);
  out.end_object();
}

void write_related(JsonWriter& out, Positions& positions, std::string_view uri,
                   std::span<const features::RelatedText> related) {
  out.key("relatedInformation");
  out.begin_array();
  for (const features::RelatedText& place : related) {
    out.begin_object();
    out.key("location");
    write_location(out, positions, uri, place.span);
    out.member("message", place.message);
    out.end_object();
  }
  out.end_array();
}

void write_diagnostic(JsonWriter& out, Positions& positions, std::string_view uri,
                      const features::ShownDiagnostic& diagnostic, const DiagnosticStyle& style) {
  out.begin_object();
  write_range(out, "range", positions.range(diagnostic.span));
  out.member("severity", severity_number(diagnostic.severity));
  out.member("code", diagnostic.code);
  if (style.code_description) {
    out.key("codeDescription");
    out.begin_object();
    out.member("href", fmt::format("{}#{}", style.docs_url, diagnostic.code));
    out.end_object();
  }
  out.member("source", "texbrdf");
  out.member("message", diagnostic.message);
  if (style.related_information && !diagnostic.related.empty()) write_related(out, positions, uri, diagnostic.related);
  out.end_object();
}

}  // namespace

void write_hover(JsonWriter& out, Positions& positions, const features::Hover& hover, features::Markup markup) {
  out.begin_object();
  out.key("contents");
  out.begin_object();
  out.member("kind", markup == features::Markup::Markdown ? "markdown" : "plaintext");
  out.member("value", hover.text);
  out.end_object();
  write_range(out, "range", positions.range(hover.span));
  out.end_object();
}

void write_definition_link(JsonWriter& out, Positions& positions, std::string_view uri,
                           const features::DefinitionLink& link) {
  out.begin_object();
  write_range(out, "originSelectionRange", positions.range(link.origin));
  out.member("targetUri", uri);
  write_range(out, "targetRange", positions.range(link.whole));
  write_range(out, "targetSelectionRange", positions.range(link.name));
  out.end_object();
}

void write_location(JsonWriter& out, Positions& positions, std::string_view uri, Span span) {
  out.begin_object();
  out.member("uri", uri);
  write_range(out, "range", positions.range(span));
  out.end_object();
}

void write_symbols(JsonWriter& out, Positions& positions, std::span<const features::Symbol> symbols) {
  out.begin_array();
  for (const features::Symbol& symbol : symbols) write_symbol(out, positions, symbol);
  out.end_array();
}

void write_flat_symbols(JsonWriter& out, Positions& positions, std::string_view uri,
                        std::span<const features::Symbol> symbols) {
  out.begin_array();
  for (const features::Symbol& symbol : symbols) {
    write_flat_symbol(out, positions, uri, symbol, {});
    for (const features::Symbol& child : symbol.children) write_flat_symbol(out, positions, uri, child, symbol.name);
  }
  out.end_array();
}

void write_diagnostics(JsonWriter& out, Positions& positions, std::string_view uri, std::optional<int64_t> version,
                       std::span<const features::ShownDiagnostic> diagnostics, const DiagnosticStyle& style) {
  out.begin_object();
  out.member("uri", uri);
  if (version) out.member("version", *version);
  out.key("diagnostics");
  out.begin_array();
  for (const features::ShownDiagnostic& diagnostic : diagnostics) {
    write_diagnostic(out, positions, uri, diagnostic, style);
  }
  out.end_array();
  out.end_object();
}

}  // namespace texbrdf::lsp
