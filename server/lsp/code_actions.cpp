#include "lsp/code_actions.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "features/code_actions.h"
#include "lsp/params_reader.h"
#include "lsp/session.h"
#include "lsp/write_edits.h"

namespace texbrdf::lsp {
namespace {

constexpr std::string_view kQuickFix = "quickfix";

/// Kinds are a hierarchy: `a` holds `a.b`, and the empty one holds all.
bool holds(std::string_view kind, std::string_view other) {
  if (kind.empty() || kind == other) return true;
  return other.starts_with(kind) && other.substr(kind.size()).starts_with('.');
}

bool are_wanted(const std::vector<std::string>& only) {
  return only.empty() || std::ranges::any_of(only, [](const std::string& kind) { return holds(kind, kQuickFix); });
}

}  // namespace

std::string read_params(nlohmann::json& params, CodeActionParams& out) {
  ParamsReader reader;
  nlohmann::json* object = reader.object_of(params);
  out.uri = reader.document_uri(object);
  out.range = reader.range(reader.object(object, "range"));
  out.only = ParamsReader::strings(ParamsReader::optional(reader.object(object, "context"), "only"));
  return reader.problem();
}

void write_code_action_options(JsonWriter& out) {
  out.key("codeActionKinds");
  out.begin_array();
  out.value(kQuickFix);
  out.end_array();
}

/// A client that takes no literals could be answered with commands only, and there are none.
Session::Outcome Session::code_action(const CodeActionParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const Snapshot& snapshot = open->document.snapshot();
  const uint32_t begin = snapshot.text().offset(params.range.start, unit_);
  const uint32_t end = snapshot.text().offset(params.range.end, unit_);
  result.begin_array();
  if (client_.code_action_literals && are_wanted(params.only)) {
    Positions places = positions(*open);
    for (features::CodeAction& action :
         features::code_actions(snapshot, {std::min(begin, end), std::max(begin, end)})) {
      write_code_action(result, places, *open, action);
    }
  }
  result.end_array();
  return std::nullopt;
}

void Session::write_code_action(JsonWriter& out, Positions& positions, const OpenDocument& open,
                                features::CodeAction& action) const {
  out.begin_object();
  out.member("title", action.title);
  out.member("kind", kQuickFix);
  std::vector<features::ShownDiagnostic> mended = as_set({std::move(action.diagnostic)});
  if (!mended.empty()) {
    out.key("diagnostics");
    write_diagnostic_items(out, positions, open.uri, mended, diagnostic_style());
  }
  if (action.is_preferred && client_.preferred_actions) out.member("isPreferred", true);
  out.key("edit");
  const FileEdits edits{open.uri, open.version, std::move(action.edits)};
  write_workspace_edit(out, positions, std::span(&edits, 1), client_.versioned_edits);
  out.end_object();
}

}  // namespace texbrdf::lsp
