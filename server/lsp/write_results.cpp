#include "lsp/write_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace texbrdf::lsp {

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

void write_position(JsonWriter& out, Position position) {
  out.begin_object();
  out.member("line", position.line);
  out.member("character", position.column);
  out.end_object();
}

namespace {

using RangeText = std::array<char, 112>;

std::string_view range_text(Range range, RangeText& text) {
  char* end = text.data();
  const auto literal = [&end](std::string_view piece) { end = std::ranges::copy(piece, end).out; };
  const auto number = [&](uint32_t value) { end = std::to_chars(end, text.data() + text.size(), value).ptr; };
  literal(R"({"start":{"line":)");
  number(range.start.line);
  literal(R"(,"character":)");
  number(range.start.column);
  literal(R"(},"end":{"line":)");
  number(range.end.line);
  literal(R"(,"character":)");
  number(range.end.column);
  literal("}}");
  return {text.data(), end};
}

}  // namespace

/// In one piece: large results are ranges for the most part.
void write_range(JsonWriter& out, std::string_view key, Range range) {
  RangeText text;
  out.key(key);
  out.raw(range_text(range, text));
}

namespace {

/// Of the file that the span is in; `own` is that of the document.
void write_uri(JsonWriter& out, std::string_view key, const Positions& positions, std::string_view own, Span span) {
  if (positions.is_elsewhere(span)) {
    out.member(key, positions.uri_elsewhere(span));
  } else {
    out.member(key, own);
  }
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

void write_unnecessary_tag(JsonWriter& out) {
  constexpr int kUnnecessary = 1;
  out.key("tags");
  out.begin_array();
  out.value(kUnnecessary);
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
  if (style.tags && diagnostic.is_unnecessary) write_unnecessary_tag(out);
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
  write_uri(out, "targetUri", positions, uri, link.name);
  write_range(out, "targetRange", positions.range(link.whole));
  write_range(out, "targetSelectionRange", positions.range(link.name));
  out.end_object();
}

void write_location(JsonWriter& out, Positions& positions, std::string_view uri, Span span) {
  out.begin_object();
  write_location_members(out, positions, uri, span);
  out.end_object();
}

void write_location_members(JsonWriter& out, Positions& positions, std::string_view uri, Span span) {
  write_uri(out, "uri", positions, uri, span);
  write_range(out, "range", positions.range(span));
}

void write_locations(JsonWriter& out, Positions& positions, std::string_view uri, std::span<const Span> spans) {
  JsonWriter own_uri;
  own_uri.value(uri);
  const std::string begin = "{\"uri\":" + own_uri.take() + ",\"range\":";
  std::string here;
  RangeText text;
  out.begin_array();
  out.reserve(spans.size() * (begin.size() + text.size() / 2));
  for (const Span span : spans) {
    if (positions.is_elsewhere(span)) {
      write_location(out, positions, uri, span);
    } else {
      here = begin;
      here.append(range_text(positions.range(span), text)) += '}';
      out.raw(here);
    }
  }
  out.end_array();
}

void write_diagnostic_items(JsonWriter& out, Positions& positions, std::string_view uri,
                            std::span<const features::ShownDiagnostic> diagnostics, const DiagnosticStyle& style) {
  out.begin_array();
  for (const features::ShownDiagnostic& diagnostic : diagnostics) {
    write_diagnostic(out, positions, uri, diagnostic, style);
  }
  out.end_array();
}

void write_diagnostics(JsonWriter& out, Positions& positions, std::string_view uri, std::optional<int64_t> version,
                       std::span<const features::ShownDiagnostic> diagnostics, const DiagnosticStyle& style) {
  out.begin_object();
  out.member("uri", uri);
  if (version) out.member("version", *version);
  out.key("diagnostics");
  write_diagnostic_items(out, positions, uri, diagnostics, style);
  out.end_object();
}

}  // namespace texbrdf::lsp
