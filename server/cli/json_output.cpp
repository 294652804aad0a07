#include "cli/json_output.h"

#include "lsp/json_writer.h"

namespace texbrdf::cli {
namespace {

using lsp::JsonWriter;

/// A JSON list with an entry a line, so that people and `grep` can read it.
class JsonLines {
 public:
  void add(JsonWriter entry) {
    text_ += text_.size() == 1 ? "\n" : ",\n";
    text_ += entry.take();
  }
  std::string take() { return std::move(text_ += text_.size() == 1 ? "]" : "\n]"); }

 private:
  std::string text_ = "[";
};

void write_place(JsonWriter& json, const SourceText& text, uint32_t offset) {
  const Position position = text.position(offset, ColumnUnit::CodePoint);
  json.begin_object();
  json.member("line", position.line + 1);
  json.member("column", position.column + 1);
  json.end_object();
}

void write_range(JsonWriter& json, const SourceText& text, Span span) {
  json.key("range");
  json.begin_object();
  json.key("start");
  write_place(json, text, span.begin);
  json.key("end");
  write_place(json, text, span.end);
  json.end_object();
}

void write_related(JsonWriter& json, const CheckedFile& file, const RelatedPlace& related) {
  const Place place = file.place(related.where);
  json.begin_object();
  json.member("file", place.file);
  json.member("message", related.message);
  write_range(json, *place.text, place.span);
  json.end_object();
}

void write_fix(JsonWriter& json, const CheckedFile& file, const Fix& fix) {
  json.begin_object();
  json.member("title", fix.title);
  json.key("edits");
  json.begin_array();
  for (const Edit& edit : fix.edits) {
    const Place place = file.place(edit.where);
    json.begin_object();
    write_range(json, *place.text, place.span);
    json.member("replacement", edit.replacement);
    json.end_object();
  }
  json.end_array();
  json.end_object();
}

JsonWriter diagnostic_json(const CheckedFile& file, const Diagnostic& diagnostic) {
  const Place place = file.place(diagnostic.where);
  JsonWriter json;
  json.begin_object();
  json.member("file", place.file);
  json.member("code", code_name(diagnostic.code));
  json.member("severity", severity_name(diagnostic.severity));
  json.member("message", message(diagnostic));
  write_range(json, *place.text, place.span);
  json.key("related");
  json.begin_array();
  for (const RelatedPlace& related : diagnostic.related) write_related(json, file, related);
  json.end_array();
  json.key("fixes");
  json.begin_array();
  for (const Fix& fix : diagnostic.fixes) write_fix(json, file, fix);
  json.end_array();
  json.end_object();
  return json;
}

// The tree of a definition

/// A tree of a thousand levels would repeat the text of its root a thousand times.
constexpr std::size_t kMaxNodeText = 1000;

std::string node_text(const ParsedBlock& block, NodeId id) {
  const std::string_view text = block.node_text(id);
  if (text.size() <= kMaxNodeText) return std::string(text);
  return std::string(text.substr(0, kMaxNodeText)) + "…";
}

struct TreeWriter {
  const Snapshot& snapshot;
  const Definition& definition;
  const ParsedBlock& block;
  uint32_t first_node;
  JsonWriter& json;

  /// Trees are at most kMaxTreeHeight high.
  void write(NodeId id) const {
    json.begin_object();
    json.member("kind", node_kind_name(block.tree.node(id).kind));
    write_range(json, snapshot.text(), snapshot.absolute(definition.block, block.span(id)));
    json.member("text", node_text(block, id));
    json.member("type", type_symbol(definition.checked->types[id.value - first_node]));
    json.key("children");
    json.begin_array();
    for (const NodeId child : block.tree.children(id)) write(child);
    json.end_array();
    json.end_object();
  }
};

}  // namespace

std::string diagnostics_json(std::span<const CheckedFile> files) {
  JsonLines list;
  for (const CheckedFile& file : files) {
    for (const Diagnostic& diagnostic : file.diagnostics) list.add(diagnostic_json(file, diagnostic));
  }
  return list.take() + "\n";
}

std::string tree_json(const Snapshot& snapshot) {
  JsonLines list;
  for (const Definition& definition : snapshot.definitions()) {
    const ParsedBlock& block = snapshot.parsed(definition.block);
    const DefinitionSyntax& syntax = block.definitions[definition.index_in_block];
    JsonWriter json;
    json.begin_object();
    json.member("name", snapshot.names().text(definition.name));
    json.member("type", signature_text(definition.checked->signature));
    json.key("tree");
    TreeWriter{snapshot, definition, block, syntax.first_node, json}.write(syntax.node);
    json.end_object();
    list.add(std::move(json));
  }
  return list.take() + "\n";
}

}  // namespace texbrdf::cli
