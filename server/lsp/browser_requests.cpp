#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "lsp/browser_params.h"
#include "lsp/session.h"
#include "lsp/uri.h"

namespace texbrdf::lsp {
namespace {

constexpr std::string_view kOpenPreviewCommand = "texbrdf.openPreview";
constexpr int kErrorMessage = 1;
constexpr int kInfoMessage = 3;
/// What a browser writes into a document is a value in the place of a value, and no page of text.
constexpr std::size_t kLongestValue = 200;

using ChangesByFile = std::map<std::string, std::vector<const WantedChange*>>;

ChangesByFile by_uri(const ApplyEditParams& params) {
  ChangesByFile files;
  for (const WantedChange& change : params.changes) files[change.uri].push_back(&change);
  return files;
}

void write_text_edits(JsonWriter& out, std::span<const WantedChange* const> changes) {
  out.begin_array();
  for (const WantedChange* change : changes) {
    out.begin_object();
    write_range(out, "range", change->range);
    out.member("newText", change->text);
    out.end_object();
  }
  out.end_array();
}

void write_document_changes(JsonWriter& out, const ChangesByFile& files) {
  out.key("documentChanges");
  out.begin_array();
  for (const auto& [uri, changes] : files) {
    out.begin_object();
    out.key("textDocument");
    out.begin_object();
    out.member("uri", uri);
    out.key("version");
    if (changes.front()->version) out.value(*changes.front()->version);
    if (!changes.front()->version) out.null();
    out.end_object();
    out.key("edits");
    write_text_edits(out, changes);
    out.end_object();
  }
  out.end_array();
}

void write_changes(JsonWriter& out, const ChangesByFile& files) {
  out.key("changes");
  out.begin_object();
  for (const auto& [uri, changes] : files) {
    out.text_key(uri);
    write_text_edits(out, changes);
  }
  out.end_object();
}

void write_apply_edit(JsonWriter& out, const ChangesByFile& files, bool versioned) {
  out.begin_object();
  out.member("label", "texbrdf preview");
  out.key("edit");
  out.begin_object();
  if (versioned) write_document_changes(out, files);
  if (!versioned) write_changes(out, files);
  out.end_object();
  out.end_object();
}

bool is_applied(const nlohmann::json& result) {
  const auto applied = result.is_object() ? result.find("applied") : result.end();
  return applied != result.end() && applied->is_boolean() && applied->get<bool>();
}

}  // namespace

void Session::serve(ViewerId viewer) {
  speaker_ = viewer;
  previews_.serve(viewer);
}

bool Session::listens_to(ViewerId viewer) const {
  return viewer == kEditor || browsers_.is_present(viewer);
}

void Session::browser_came(ViewerId browser) {
  browsers_.add(browser);
  log_.debug(fmt::format("browser {} is there", browser));
}

void Session::browser_went(ViewerId browser) {
  browsers_.remove(browser);
  previews_.close_all_of(browser);
  scene_previews_.close_all_of(browser);
  log_.debug(fmt::format("browser {} is gone", browser));
}

void Session::lead_browsers() {
  if (!browsers_.are_served()) return;
  const OpenDocument* last = nullptr;
  for (const auto& [uri, open] : documents_.all()) {
    if (last == nullptr || open.touched > last->touched) last = &open;
  }
  std::optional<FollowedDocument> followed;
  if (last != nullptr) followed = {last->uri, last->version.value_or(0)};
  uint64_t touched = last == nullptr ? 0 : last->touched;
  for (const auto& [uri, scene] : scenes_.all()) {
    if (scene.touched <= touched) continue;
    touched = scene.touched;
    followed = {scene.uri, scene.version.value_or(0)};
  }
  browsers_.follow(std::move(followed));
}

/// Where the preview for browsers is, or why there is none; nothing where nobody asked for it.
void Session::tell_url() {
  if (!browsers_.are_served() && browsers_.problem().empty()) return;
  outbox_.notify("window/showMessage", [&](JsonWriter& out) {
    out.begin_object();
    out.member("type", browsers_.are_served() ? kInfoMessage : kErrorMessage);
    out.member("message", "BRDF preview: " + (browsers_.are_served() ? browsers_.url() : browsers_.problem()));
    out.end_object();
  });
}

/// One that is open, or that belongs with one.
bool Session::is_known_file(std::string_view uri) {
  documents_.projects().settle();
  if (documents_.find(uri) != nullptr) return true;
  const std::string path = shown_path(uri);
  return std::ranges::any_of(documents_.all(),
                             [&](auto& entry) { return entry.second.document.project().find(path).has_value(); });
}

/// Why the editor is not asked to make the change, or nothing.
std::optional<std::string> Session::fault_of(const WantedChange& change) {
  if (!is_known_file(change.uri)) return fmt::format("{} is no file of an open document", shown_path(change.uri));
  const bool is_value = change.text.size() <= kLongestValue && change.text.find_first_of("\r\n") == std::string::npos;
  if (!is_value) return "what is to be written is no value";
  const auto& [start, end] = change.range;
  if (start.line != end.line || end.column - start.column > kLongestValue) return "what is to be replaced is no value";
  const OpenDocument* const open = documents_.find(change.uri);
  if (open != nullptr && change.version != open->version) return "the document has changed since";
  return std::nullopt;
}

/// What the editor says comes later, as `texbrdf/edited`.
Session::Outcome Session::apply_edit(const ApplyEditParams& params, JsonWriter& result) {
  if (speaker_ == kEditor) return ResponseError{ErrorCode::MethodNotFound, "only for browsers"};
  if (!client_.applies_edits) return ResponseError{ErrorCode::RequestFailed, "the editor takes no edits"};
  for (const WantedChange& change : params.changes) {
    if (auto fault = fault_of(change)) return ResponseError{ErrorCode::RequestFailed, *std::move(fault)};
  }
  const int64_t edit = ++last_edit_;
  outbox_.request(
      "workspace/applyEdit", [&](JsonWriter& out) { write_apply_edit(out, by_uri(params), client_.versioned_edits); },
      [this, edit, browser = speaker_](const nlohmann::json& reply) {
        browsers_.notify(browser, "texbrdf/edited", [&](JsonWriter& out) {
          out.begin_object();
          out.member("edit", edit);
          out.member("applied", is_applied(reply));
          out.end_object();
        });
      });
  result.begin_object();
  result.member("edit", edit);
  result.end_object();
  return std::nullopt;
}

Session::Outcome Session::reveal(const RevealParams& params, JsonWriter& result) {
  if (speaker_ == kEditor) return ResponseError{ErrorCode::MethodNotFound, "only for browsers"};
  if (!client_.shows_documents) return ResponseError{ErrorCode::RequestFailed, "the editor cannot be led to a place"};
  if (!is_known_file(params.uri)) {
    return ResponseError{ErrorCode::RequestFailed, shown_path(params.uri) + " is no file of an open document"};
  }
  outbox_.request("window/showDocument", [&](JsonWriter& out) {
    out.begin_object();
    out.member("uri", params.uri);
    out.member("takeFocus", true);
    write_range(out, "selection", params.range);
    out.end_object();
  });
  result.null();
  return std::nullopt;
}

Session::Outcome Session::execute_command(const ExecuteCommandParams& params, JsonWriter& result) {
  if (params.command != kOpenPreviewCommand || !browsers_.are_served()) {
    return ResponseError{ErrorCode::InvalidParams, fmt::format("no command {}", params.command)};
  }
  if (client_.shows_documents) {
    outbox_.request("window/showDocument", [&](JsonWriter& out) {
      out.begin_object();
      out.member("uri", browsers_.url());
      out.member("external", true);
      out.end_object();
    });
  } else {
    tell_url();
  }
  result.value(browsers_.url());
  return std::nullopt;
}

void Session::write_commands(JsonWriter& out) const {
  if (!browsers_.are_served()) return;
  out.key("executeCommandProvider");
  out.begin_object();
  out.key("commands");
  out.begin_array();
  out.value(kOpenPreviewCommand);
  out.end_array();
  out.end_object();
}

}  // namespace texbrdf::lsp
