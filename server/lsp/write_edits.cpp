#include "lsp/write_edits.h"

#include "lsp/write_results.h"

namespace texbrdf::lsp {
namespace {

void write_edits(JsonWriter& out, Positions& positions, std::span<const features::TextEdit> edits) {
  out.begin_array();
  for (const features::TextEdit& edit : edits) {
    out.begin_object();
    write_range(out, "range", positions.range(edit.span));
    out.member("newText", edit.text);
    out.end_object();
  }
  out.end_array();
}

void write_versioned_edits(JsonWriter& out, Positions& positions, const OpenDocument& open,
                           std::span<const features::TextEdit> edits) {
  out.key("documentChanges");
  out.begin_array();
  out.begin_object();
  out.key("textDocument");
  out.begin_object();
  out.member("uri", open.uri);
  out.key("version");
  if (open.version) out.value(*open.version);
  if (!open.version) out.null();
  out.end_object();
  out.key("edits");
  write_edits(out, positions, edits);
  out.end_object();
  out.end_array();
}

}  // namespace

void write_workspace_edit(JsonWriter& out, Positions& positions, const OpenDocument& open,
                          std::span<const features::TextEdit> edits, bool versioned) {
  out.begin_object();
  if (versioned) {
    write_versioned_edits(out, positions, open, edits);
  } else {
    out.key("changes");
    out.begin_object();
    out.text_key(open.uri);
    write_edits(out, positions, edits);
    out.end_object();
  }
  out.end_object();
}

}  // namespace texbrdf::lsp
