#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "lsp/session.h"
#include "lsp/uri.h"
#include "source/internal_error.h"

namespace texbrdf::lsp {
namespace {

std::string closed_problem(std::string_view uri) {
  return fmt::format("{} is not open", shown_path(uri));
}

}  // namespace

std::string Session::did_open(const DidOpenParams& params) {
  if (params.text.size() > SourceText::kMaxBytes) return "the document is too long";
  std::erase(closed_, params.uri);
  documents_.open(params.uri, params.text, params.version);
  log_.debug(fmt::format("{} is open, {}, version {}, {} bytes", shown_path(params.uri), params.language_id,
                         params.version, params.text.size()));
  return {};
}

std::string Session::did_change(const DidChangeParams& params) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return closed_problem(params.uri);
  for (const ContentChange& change : params.changes) apply(change, open->document);
  open->version = params.version;
  open->published = false;
  return {};
}

/// Changes of one message are applied one after the other, each to the text that the one before left.
void Session::apply(const ContentChange& change, Document& document) const {
  if (!change.range) {
    document.set_text(change.text);
    return;
  }
  const SourceText& text = document.text();
  const uint32_t begin = text.offset(change.range->start, unit_);
  const uint32_t end = text.offset(change.range->end, unit_);
  document.replace({std::min(begin, end), std::max(begin, end)}, change.text);
}

std::string Session::did_save(const DocumentParams& params) {
  return documents_.find(params.uri) == nullptr ? closed_problem(params.uri) : std::string{};
}

std::string Session::did_close(const DocumentParams& params) {
  if (!documents_.close(params.uri)) return closed_problem(params.uri);
  closed_.push_back(params.uri);
  return {};
}

void Session::write_next_publication(JsonWriter& out) {
  const DiagnosticStyle style{client_.related_information, client_.code_description, docs_url_};
  if (!closed_.empty()) {
    const std::string uri = std::move(closed_.back());
    closed_.pop_back();
    const SourceText nothing;
    Positions positions(nothing, unit_);
    write_diagnostics(out, positions, uri, std::nullopt, {}, style);
    return;
  }
  OpenDocument* open = documents_.next_unpublished();
  require(open != nullptr, "nothing to publish");
  open->published = true;
  const Snapshot& snapshot = open->document.snapshot();
  Positions positions(snapshot.text(), unit_);
  write_diagnostics(out, positions, open->uri, open->version, features::diagnostics(snapshot), style);
}

}  // namespace texbrdf::lsp
