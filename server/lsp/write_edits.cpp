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

void write_versioned_edits(JsonWriter& out, Positions& positions, const FileEdits& file) {
  out.begin_object();
  out.key("textDocument");
  out.begin_object();
  out.member("uri", file.uri);
  out.key("version");
  if (file.version) out.value(*file.version);
  if (!file.version) out.null();
  out.end_object();
  out.key("edits");
  write_edits(out, positions, file.edits);
  out.end_object();
}

}  // namespace

void write_workspace_edit(JsonWriter& out, Positions& positions, std::span<const FileEdits> files, bool versioned) {
  out.begin_object();
  if (versioned) {
    out.key("documentChanges");
    out.begin_array();
    for (const FileEdits& file : files) write_versioned_edits(out, positions, file);
    out.end_array();
  } else {
    out.key("changes");
    out.begin_object();
    for (const FileEdits& file : files) {
      out.text_key(file.uri);
      write_edits(out, positions, file.edits);
    }
    out.end_object();
  }
  out.end_object();
}

}  // namespace texbrdf::lsp
