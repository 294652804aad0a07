#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "lsp/progress.h"
#include "lsp/session.h"
#include "lsp/uri.h"

namespace texbrdf::lsp {
namespace {

/// Documents from this size on take long enough to be worth a sign: about a tenth of a second.
constexpr std::size_t kLargeDocumentBytes = std::size_t{1} << 20;

std::string closed_problem(std::string_view uri) {
  return fmt::format("{} is not open", shown_path(uri));
}

}  // namespace

std::string Session::did_open(const DidOpenParams& params) {
  if (params.text.size() > SourceText::kMaxBytes) return "the document is too long";
  std::erase(closed_, params.uri);
  if (is_scene_uri(params.uri)) return open_scene_document(params);
  previews_.note_change();
  OpenDocument& open = documents_.open(params.uri, params.text, params.version, params.language_id);
  open.touched = ++last_touch_;
  scenes_.note_change(open.document.buffer().path);
  log_.debug(fmt::format("{} is open, {}, version {}, {} bytes", shown_path(params.uri), params.language_id,
                         params.version, params.text.size()));
  if (client_.work_done_progress && params.text.size() >= kLargeDocumentBytes) analyse_visibly(open);
  return {};
}

std::string Session::did_change(const DidChangeParams& params) {
  if (scenes_.find(params.uri) != nullptr) return change_scene_document(params);
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return closed_problem(params.uri);
  for (const ContentChange& change : params.changes) apply(change, *open);
  open->version = params.version;
  open->published = false;
  open->touched = ++last_touch_;
  scenes_.note_change(open->document.buffer().path);
  previews_.note_change();
  return {};
}

/// Changes of one message are applied one after the other, each to the text that the one before left.
void Session::apply(const ContentChange& change, OpenDocument& open) const {
  if (!change.range) {
    open.document.set_text(change.text);
    open.semantic_tokens.text_set();
    return;
  }
  const SourceText& text = open.document.text();
  const uint32_t begin = text.offset(change.range->start, unit_);
  const uint32_t end = text.offset(change.range->end, unit_);
  const Span replaced{std::min(begin, end), std::max(begin, end)};
  open.semantic_tokens.text_replaced(replaced, text.size());
  open.document.replace(replaced, change.text);
}

std::string Session::did_save(const DocumentParams& params) {
  const bool is_open = documents_.find(params.uri) != nullptr || scenes_.find(params.uri) != nullptr;
  return is_open ? std::string{} : closed_problem(params.uri);
}

std::string Session::did_close(const DocumentParams& params) {
  if (scenes_.find(params.uri) != nullptr) return close_scene_document(params);
  OpenDocument* const open = documents_.find(params.uri);
  if (open == nullptr) return closed_problem(params.uri);
  const std::string path = open->document.buffer().path;
  documents_.close(params.uri);
  scenes_.note_change(path);
  if (pushes_diagnostics()) closed_.push_back(params.uri);
  previews_.close_all(params.uri);
  late_findings_.forget(params.uri);
  return {};
}

/// The first analysis of a large document, which is the only slow one. That the client knows the token is not waited
/// for: it reads messages in their order.
void Session::analyse_visibly(OpenDocument& open) {
  const std::string token = fmt::format("\"texbrdf/{}\"", ++last_progress_);
  outbox_.request("window/workDoneProgress/create", [&](JsonWriter& out) {
    out.begin_object();
    out.key("token");
    out.raw(token);
    out.end_object();
  });
  const Progress progress(outbox_, token, fmt::format("analysing {}", shown_path(open.uri)));
  open.document.snapshot();
}

}  // namespace texbrdf::lsp
