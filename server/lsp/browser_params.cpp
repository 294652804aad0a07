#include "lsp/browser_params.h"

#include "lsp/params_reader.h"

namespace texbrdf::lsp {
namespace {

using nlohmann::json;
using Reader = ParamsReader;

WantedChange wanted_change(Reader& reader, json* object) {
  WantedChange change;
  change.uri = reader.string(object, "uri");
  if (Reader::optional(object, "version") != nullptr) change.version = reader.integer(object, "version");
  change.range = reader.range(reader.object(object, "range"));
  change.text = reader.string(object, "newText");
  return change;
}

}  // namespace

std::string read_params(json& params, ApplyEditParams& out) {
  Reader reader;
  json* changes = reader.array(reader.object_of(params), "changes");
  if (changes == nullptr) return reader.problem();
  for (json& change : *changes) {
    if (change.is_object()) {
      out.changes.push_back(wanted_change(reader, &change));
    } else {
      reader.fail("`changes` has to be an array of objects");
    }
  }
  return reader.problem();
}

std::string read_params(json& params, RevealParams& out) {
  Reader reader;
  json* object = reader.object_of(params);
  out.uri = reader.string(object, "uri");
  out.range = reader.range(reader.object(object, "range"));
  return reader.problem();
}

std::string read_params(json& params, ExecuteCommandParams& out) {
  Reader reader;
  out.command = reader.string(reader.object_of(params), "command");
  return reader.problem();
}

}  // namespace texbrdf::lsp
