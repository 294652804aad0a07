#include "lsp/signature_help.h"

#include "features/signature_help.h"
#include "lsp/markup.h"
#include "lsp/session.h"

namespace texbrdf::lsp {
namespace {

/// Offsets in a label count UTF-16 units, whatever positions count.
void write_parameter(JsonWriter& out, const SourceText& label, Span span, bool offsets) {
  out.begin_object();
  if (offsets) {
    out.key("label");
    out.begin_array();
    out.value(label.position(span.begin, ColumnUnit::Utf16).column);
    out.value(label.position(span.end, ColumnUnit::Utf16).column);
    out.end_array();
  } else {
    out.member("label", label.slice(span));
  }
  out.end_object();
}

}  // namespace

void write_signature_help_options(JsonWriter& out) {
  out.key("triggerCharacters");
  out.begin_array();
  for (const char* character : {"(", ","}) out.value(character);
  out.end_array();
}

Session::Outcome Session::signature_help(const PositionParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const Snapshot& snapshot = open->document.snapshot();
  const features::Markup markup = preferred_markup(client_.signature_formats, features::Markup::PlainText);
  const auto help = features::signature_help(snapshot, snapshot.text().offset(params.position, unit_), markup);
  if (!help) {
    result.null();
    return std::nullopt;
  }
  const SourceText label(help->label);
  result.begin_object();
  result.key("signatures");
  result.begin_array();
  result.begin_object();
  result.member("label", help->label);
  if (!help->documentation.empty()) write_markup(result, "documentation", help->documentation, markup);
  result.key("parameters");
  result.begin_array();
  for (const Span span : help->parameters) write_parameter(result, label, span, client_.label_offsets);
  result.end_array();
  result.end_object();
  result.end_array();
  result.member("activeSignature", 0);
  result.member("activeParameter", help->active);
  result.end_object();
  return std::nullopt;
}

}  // namespace texbrdf::lsp
