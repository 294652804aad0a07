#include <fmt/format.h>

#include "features/definition.h"
#include "features/references.h"
#include "lsp/session.h"
#include "lsp/uri.h"

namespace texbrdf::lsp {

ResponseError Session::not_open(std::string_view uri) {
  return {ErrorCode::InvalidParams, fmt::format("{} is not open", shown_path(uri))};
}

Session::Outcome Session::definition(const PositionParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const Snapshot& snapshot = open->document.snapshot();
  const auto link = features::definition_at(snapshot, snapshot.text().offset(params.position, unit_));
  Positions places = positions(*open);
  if (!link) {
    result.null();
  } else if (client_.definition_links) {
    result.begin_array();
    write_definition_link(result, places, params.uri, *link);
    result.end_array();
  } else {
    write_location(result, places, params.uri, link->name);
  }
  return std::nullopt;
}

Session::Outcome Session::references(const ReferenceParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const Snapshot& snapshot = open->document.snapshot();
  const uint32_t offset = snapshot.text().offset(params.position, unit_);
  Positions places = positions(*open);
  write_locations(result, places, params.uri, features::references(snapshot, offset, params.include_declaration));
  return std::nullopt;
}

Session::Outcome Session::stats(const NoParams&, JsonWriter& result) {
  result.begin_object();
  result.member("requests", traffic_.requests);
  result.member("notifications", traffic_.notifications);
  result.member("cancelled", traffic_.cancelled);
  result.member("errors", traffic_.errors);
  result.member("published", traffic_.published);
  result.key("workspaceFolders");
  result.begin_array();
  for (const std::string& uri : folders_.uris()) result.value(uri);
  result.end_array();
  result.key("documents");
  result.begin_array();
  for (auto& [uri, open] : documents_.all()) {
    const Snapshot& snapshot = open.document.snapshot();
    const Counters counters = snapshot.counters();
    result.begin_object();
    result.member("uri", uri);
    result.key("version");
    if (open.version) result.value(*open.version);
    if (!open.version) result.null();
    result.member("bytes", snapshot.text().size());
    result.member("blocks", snapshot.blocks().size());
    result.member("definitions", snapshot.definitions().size());
    result.member("blocksScanned", counters.blocks_scanned);
    result.member("blocksParsed", counters.blocks_parsed);
    result.member("definitionsChecked", counters.definitions_checked);
    result.member("diagnosticsPending", pushes_diagnostics() && (!open.published || open.lacks_findings));
    result.end_object();
  }
  result.end_array();
  result.end_object();
  return std::nullopt;
}

}  // namespace texbrdf::lsp
