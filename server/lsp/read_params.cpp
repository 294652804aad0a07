#include "lsp/read_params.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "lsp/params_reader.h"
#include "lsp/providers.h"

namespace texbrdf::lsp {

using nlohmann::json;
using Reader = ParamsReader;

namespace {

std::vector<std::string> folder_uris(json* folders) {
  std::vector<std::string> uris;
  if (folders == nullptr || !folders->is_array()) return uris;
  for (json& folder : *folders) {
    std::string uri = Reader::text_or_empty(&folder, "uri");
    if (!uri.empty()) uris.push_back(std::move(uri));
  }
  return uris;
}

/// Clients from before there were several folders name one, as a URI or as a path.
std::vector<std::string> workspace_folders(json* params) {
  if (json* folders = Reader::optional(params, "workspaceFolders")) return folder_uris(folders);
  if (std::string uri = Reader::text_or_empty(params, "rootUri"); !uri.empty()) return {std::move(uri)};
  if (std::string path = Reader::text_or_empty(params, "rootPath"); !path.empty()) return {"file://" + path};
  return {};
}

void read_features(json* documents, json* workspace, InitializeParams& out) {
  for (const Provider& provider : providers()) {
    const auto index = static_cast<std::size_t>(provider.feature);
    json* capability = Reader::optional(documents, provider.client_capability);
    out.registration[index] = Reader::flag(capability, "dynamicRegistration");
    out.refresh[index] = Reader::flag(Reader::optional(workspace, provider.refresh_capability), "refreshSupport");
  }
  out.pull_diagnostics = Reader::optional(documents, "diagnostic") != nullptr;
  out.prepare_rename = Reader::flag(Reader::optional(documents, "rename"), "prepareSupport");
}

void read_typing_features(json* documents, InitializeParams& out) {
  json* item = Reader::optional(Reader::optional(documents, "completion"), "completionItem");
  out.snippets = Reader::flag(item, "snippetSupport");
  out.completion_formats = Reader::strings(Reader::optional(item, "documentationFormat"));
  json* signature = Reader::optional(Reader::optional(documents, "signatureHelp"), "signatureInformation");
  out.signature_formats = Reader::strings(Reader::optional(signature, "documentationFormat"));
  out.label_offsets = Reader::flag(Reader::optional(signature, "parameterInformation"), "labelOffsetSupport");
  json* action = Reader::optional(documents, "codeAction");
  out.code_action_literals = Reader::optional(action, "codeActionLiteralSupport") != nullptr;
  out.preferred_actions = Reader::flag(action, "isPreferredSupport");
}

}  // namespace

std::string read_params(json&, NoParams&) {
  return {};
}

/// What a client says of itself is taken as far as it is understood: odd capabilities are no reason to refuse it.
std::string read_params(json& params, InitializeParams& out) {
  Reader reader;
  json* object = reader.object_of(params);
  if (Reader::optional(object, "processId") != nullptr) out.process_id = reader.integer(object, "processId");
  json* client = Reader::optional(object, "clientInfo");
  out.client_name = Reader::text_or_empty(client, "name");
  out.client_version = Reader::text_or_empty(client, "version");

  json* capabilities = Reader::optional(object, "capabilities");
  json* documents = Reader::optional(capabilities, "textDocument");
  json* published = Reader::optional(documents, "publishDiagnostics");
  out.position_encodings =
      Reader::strings(Reader::optional(Reader::optional(capabilities, "general"), "positionEncodings"));
  out.hover_formats = Reader::strings(Reader::optional(Reader::optional(documents, "hover"), "contentFormat"));
  out.markdown_parser = Reader::optional(Reader::optional(capabilities, "general"), "markdown") != nullptr;
  out.definition_links = Reader::flag(Reader::optional(documents, "definition"), "linkSupport");
  out.hierarchical_symbols =
      Reader::flag(Reader::optional(documents, "documentSymbol"), "hierarchicalDocumentSymbolSupport");
  out.related_information = Reader::flag(published, "relatedInformation");
  out.diagnostic_tags = Reader::optional(published, "tagSupport") != nullptr;
  out.file_watchers = Reader::flag(
      Reader::optional(Reader::optional(capabilities, "workspace"), "didChangeWatchedFiles"), "dynamicRegistration");
  read_typing_features(documents, out);
  out.folds_lines_only = Reader::flag(Reader::optional(documents, "foldingRange"), "lineFoldingOnly");
  json* extensions = Reader::optional(Reader::optional(capabilities, "experimental"), "texbrdf");
  out.commands = Reader::strings(Reader::optional(extensions, "commands"));
  out.code_description = Reader::flag(published, "codeDescriptionSupport");

  json* workspace = Reader::optional(capabilities, "workspace");
  json* changed_configuration = Reader::optional(workspace, "didChangeConfiguration");
  read_features(documents, workspace, out);
  out.versioned_edits = Reader::flag(Reader::optional(workspace, "workspaceEdit"), "documentChanges");
  out.configuration = Reader::flag(workspace, "configuration");
  out.configuration_registration = Reader::flag(changed_configuration, "dynamicRegistration");
  out.applies_edits = Reader::flag(workspace, "applyEdit");
  json* window = Reader::optional(capabilities, "window");
  out.work_done_progress = Reader::flag(window, "workDoneProgress");
  out.shows_documents = Reader::flag(Reader::optional(window, "showDocument"), "support");
  out.folders = workspace_folders(object);
  if (const json* options = Reader::optional(object, "initializationOptions")) {
    out.setting_problems = apply_settings(*options, out.settings);
  }
  return reader.problem();
}

std::string read_params(json& params, DidOpenParams& out) {
  Reader reader;
  json* document = reader.object(reader.object_of(params), "textDocument");
  out.uri = reader.string(document, "uri");
  out.language_id = Reader::text_or_empty(document, "languageId");
  out.version = reader.integer(document, "version");
  out.text = reader.string(document, "text");
  return reader.problem();
}

std::string read_params(json& params, DidChangeParams& out) {
  Reader reader;
  json* object = reader.object_of(params);
  json* document = reader.object(object, "textDocument");
  out.uri = reader.string(document, "uri");
  if (Reader::optional(document, "version") != nullptr) out.version = reader.integer(document, "version");
  json* changes = reader.array(object, "contentChanges");
  if (changes == nullptr) return reader.problem();
  for (json& change : *changes) {
    if (!change.is_object()) {
      reader.fail("`contentChanges` has to be an array of objects");
      break;
    }
    ContentChange& added = out.changes.emplace_back();
    if (json* range = Reader::optional(&change, "range")) added.range = reader.range(range);
    added.text = reader.string(&change, "text");
  }
  return reader.problem();
}

std::string read_params(json& params, DocumentParams& out) {
  Reader reader;
  out.uri = reader.document_uri(reader.object_of(params));
  return reader.problem();
}

std::string read_params(json& params, PositionParams& out) {
  Reader reader;
  json* object = reader.object_of(params);
  out.uri = reader.document_uri(object);
  out.position = reader.position(object, "position");
  return reader.problem();
}

std::string read_params(json& params, RangeParams& out) {
  Reader reader;
  json* object = reader.object_of(params);
  out.uri = reader.document_uri(object);
  out.range = reader.range(reader.object(object, "range"));
  return reader.problem();
}

std::string read_params(json& params, ReferenceParams& out) {
  Reader reader;
  json* object = reader.object_of(params);
  out.uri = reader.document_uri(object);
  out.position = reader.position(object, "position");
  out.include_declaration = reader.boolean(reader.object(object, "context"), "includeDeclaration");
  return reader.problem();
}

std::string read_params(json& params, PullParams& out) {
  Reader reader;
  json* object = reader.object_of(params);
  out.uri = reader.document_uri(object);
  out.previous_result = Reader::text_or_empty(object, "previousResultId");
  return reader.problem();
}

std::string read_params(json& params, RenameParams& out) {
  Reader reader;
  json* object = reader.object_of(params);
  out.uri = reader.document_uri(object);
  out.position = reader.position(object, "position");
  out.new_name = reader.string(object, "newName");
  return reader.problem();
}

std::string read_params(json& params, WorkspaceFoldersParams& out) {
  Reader reader;
  json* event = reader.object(reader.object_of(params), "event");
  out.added = folder_uris(Reader::optional(event, "added"));
  out.removed = folder_uris(Reader::optional(event, "removed"));
  return reader.problem();
}

}  // namespace texbrdf::lsp
