#include "cli/sarif.h"

#include "lsp/json_writer.h"
#include "lsp/uri.h"

namespace texbrdf::cli {
namespace {

using lsp::JsonWriter;

std::string_view level(Severity severity) {
  switch (severity) {
    case Severity::Error:
      return "error";
    case Severity::Warning:
      return "warning";
    case Severity::Information:
    case Severity::Hint:
      return "note";
  }
  return "none";
}

/// SARIF wraps every text in an object.
void write_text(JsonWriter& json, std::string_view key, std::string_view text) {
  json.key(key);
  json.begin_object();
  json.member("text", text);
  json.end_object();
}

void write_rules(JsonWriter& json) {
  json.key("rules");
  json.begin_array();
  for (const CatalogueEntry& entry : catalogue()) {
    json.begin_object();
    json.member("id", code_name(entry.code));
    json.member("name", entry.name);
    write_text(json, "shortDescription", entry.text);
    write_text(json, "fullDescription", entry.explanation);
    json.key("defaultConfiguration");
    json.begin_object();
    json.member("level", level(entry.severity));
    json.end_object();
    json.end_object();
  }
  json.end_array();
}

void write_tool(JsonWriter& json) {
  json.key("tool");
  json.begin_object();
  json.key("driver");
  json.begin_object();
  json.member("name", "texbrdf");
  json.member("version", TEXBRDF_VERSION);
  write_rules(json);
  json.end_object();
  json.end_object();
}

/// A relative path stays relative.
std::string uri_reference(std::string_view path) {
  return path.starts_with('/') ? lsp::file_uri(path) : lsp::percent_encoded(path);
}

void write_artifact(JsonWriter& json, std::string_view file_name) {
  json.key("artifactLocation");
  json.begin_object();
  json.member("uri", uri_reference(file_name));
  json.end_object();
}

void write_region(JsonWriter& json, std::string_view key, const Place& place) {
  const Position start = place.text->position(place.span.begin, ColumnUnit::CodePoint);
  const Position end = place.text->position(place.span.end, ColumnUnit::CodePoint);
  json.key(key);
  json.begin_object();
  json.member("startLine", start.line + 1);
  json.member("startColumn", start.column + 1);
  json.member("endLine", end.line + 1);
  json.member("endColumn", end.column + 1);
  json.end_object();
}

void write_place(JsonWriter& json, const CheckedFile& file, const Location& where) {
  json.key("physicalLocation");
  json.begin_object();
  const Place place = file.place(where);
  write_artifact(json, place.file);
  write_region(json, "region", place);
  json.end_object();
}

void write_fix(JsonWriter& json, const CheckedFile& file, const Fix& fix) {
  json.begin_object();
  write_text(json, "description", fix.title);
  json.key("artifactChanges");
  json.begin_array();
  json.begin_object();
  write_artifact(json, file.place(fix.edits.front().where).file);
  json.key("replacements");
  json.begin_array();
  for (const Edit& edit : fix.edits) {
    json.begin_object();
    write_region(json, "deletedRegion", file.place(edit.where));
    write_text(json, "insertedContent", edit.replacement);
    json.end_object();
  }
  json.end_array();
  json.end_object();
  json.end_array();
  json.end_object();
}

void write_result(JsonWriter& json, const CheckedFile& file, const Diagnostic& diagnostic) {
  json.begin_object();
  json.member("ruleId", code_name(diagnostic.code));
  json.member("level", level(diagnostic.severity));
  write_text(json, "message", message(diagnostic));
  json.key("locations");
  json.begin_array();
  json.begin_object();
  write_place(json, file, diagnostic.where);
  json.end_object();
  json.end_array();
  json.key("relatedLocations");
  json.begin_array();
  for (const RelatedPlace& related : diagnostic.related) {
    json.begin_object();
    write_place(json, file, related.where);
    write_text(json, "message", related.message);
    json.end_object();
  }
  json.end_array();
  json.key("fixes");
  json.begin_array();
  for (const Fix& fix : diagnostic.fixes) write_fix(json, file, fix);
  json.end_array();
  json.end_object();
}

}  // namespace

std::string diagnostics_sarif(std::span<const CheckedFile> files) {
  JsonWriter json;
  json.begin_object();
  json.member("$schema", "https://json.schemastore.org/sarif-2.1.0.json");
  json.member("version", "2.1.0");
  json.key("runs");
  json.begin_array();
  json.begin_object();
  write_tool(json);
  json.member("columnKind", "unicodeCodePoints");
  json.key("results");
  json.begin_array();
  for (const CheckedFile& file : files) {
    for (const Diagnostic& diagnostic : file.diagnostics) write_result(json, file, diagnostic);
  }
  json.end_array();
  json.end_object();
  json.end_array();
  json.end_object();
  return json.take() + "\n";
}

}  // namespace texbrdf::cli
