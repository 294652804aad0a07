#include "emit/emit.h"

#include "features/places.h"
#include "lsp/session.h"

namespace texbrdf::lsp {
namespace {

void write_place(JsonWriter& out, Positions& positions, std::string_view uri, const Snapshot& snapshot,
                 const emit::CodeLines& lines) {
  const std::optional<DefinitionId> definition = snapshot.find(lines.name);
  if (!definition) return;
  out.begin_object();
  write_location_members(out, positions, uri, features::definition_span(snapshot, *definition));
  out.member("name", snapshot.names().text(lines.name));
  out.key("lines");
  out.begin_array();
  out.value(lines.first);
  out.value(lines.last);
  out.end_array();
  out.end_object();
}

}  // namespace

Session::Outcome Session::emit(const EmitParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const emit::Target* const target = emit::find_target(params.target);
  if (target == nullptr) return ResponseError{ErrorCode::InvalidParams, "no target " + params.target};
  const Snapshot& snapshot = open->document.snapshot();
  const Result<ir::Program> program = snapshot.program(params.root);
  const Result<emit::EmittedCode> code = program ? target->emit(*program, {}) : Failure{program.error()};
  result.begin_object();
  result.key("text");
  if (!code) {
    result.null();
    result.member("problem", code.error());
    result.end_object();
    return std::nullopt;
  }
  result.value(code->text);
  Positions places = positions(*open);
  result.key("places");
  result.begin_array();
  for (const emit::CodeLines& lines : code->lines) write_place(result, places, params.uri, snapshot, lines);
  result.end_array();
  result.end_object();
  return std::nullopt;
}

}  // namespace texbrdf::lsp
