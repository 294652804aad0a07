#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "lsp/capabilities.h"
#include "lsp/session.h"
#include "lsp/uri.h"
#include "source/internal_error.h"

namespace texbrdf::lsp {
namespace {

Severity severity_of(HintSeverity chosen) {
  switch (chosen) {
    case HintSeverity::Information:
      return Severity::Information;
    case HintSeverity::Warning:
      return Severity::Warning;
    case HintSeverity::Off:
    case HintSeverity::Hint:
      break;
  }
  return Severity::Hint;
}

}  // namespace

DiagnosticStyle Session::diagnostic_style() const {
  return {client_.related_information, client_.code_description, client_.diagnostic_tags, docs_url_};
}

std::vector<std::vector<features::ShownDiagnostic>> Session::shown_by_file(
    const Snapshot& snapshot, const features::NumericFindings* findings) const {
  std::vector<std::vector<features::ShownDiagnostic>> files = features::diagnostics_by_file(snapshot, findings);
  for (std::vector<features::ShownDiagnostic>& shown : files) shown = as_set(std::move(shown));
  return files;
}

/// As the settings want them.
std::vector<features::ShownDiagnostic> Session::as_set(std::vector<features::ShownDiagnostic> shown) const {
  const auto is_hint = [](const features::ShownDiagnostic& d) { return d.severity == Severity::Hint; };
  if (settings_.hint_severity == HintSeverity::Off) std::erase_if(shown, is_hint);
  for (features::ShownDiagnostic& diagnostic : shown) {
    if (is_hint(diagnostic)) diagnostic.severity = severity_of(settings_.hint_severity);
  }
  return shown;
}

void Session::write_next_publication(JsonWriter& out) {
  if (!closed_.empty()) {
    const std::string uri = std::move(closed_.back());
    closed_.pop_back();
    const SourceText nothing;
    Positions positions(nothing, unit_);
    write_diagnostics(out, positions, uri, std::nullopt, {}, diagnostic_style());
    return;
  }
  if (!elsewhere_.empty()) {
    const std::string path = std::move(elsewhere_.back());
    elsewhere_.pop_back();
    out.begin_object();
    out.member("uri", file_uri(path));
    out.key("diagnostics");
    out.raw(shown_elsewhere_[path]);
    out.end_object();
    return;
  }
  if (const auto problems = shows_scene_problems() ? scenes_.next_problems(unit_) : std::nullopt) {
    return write_scene_problems(out, *problems);
  }
  OpenDocument* open = documents_.next_unpublished();
  require(open != nullptr, "nothing to publish");
  open->published = true;
  const Snapshot& snapshot = open->document.snapshot();
  const LateFindings::Findings findings = late_findings_.of(open->uri, snapshot);
  open->lacks_findings = findings == nullptr;
  Positions places = positions(*open);
  const std::vector<std::vector<features::ShownDiagnostic>> by_file = shown_by_file(snapshot, findings.get());
  const std::vector<features::ShownDiagnostic>& own = by_file[snapshot.file().value];
  write_diagnostics(out, places, open->uri, open->version, own, diagnostic_style());
  show_elsewhere(*open, by_file);
}

/// The client was told that it can ask for diagnostics: then it gets no others.
bool Session::is_pulled() const {
  constexpr auto kIndex = static_cast<std::size_t>(Feature::Diagnostics);
  return registered_[kIndex] || is_announced(Feature::Diagnostics, client_, client_.settings);
}

/// What the client was sent is no longer right, or no longer for it to have.
void Session::publish_anew(bool pushed_before) {
  for (auto& [uri, open] : documents_.all()) {
    open.published = false;
    if (pushed_before && !pushes_diagnostics()) closed_.push_back(uri);
  }
  const std::vector<std::string> told = scenes_.forget_told();
  if (!shows_scene_problems()) closed_.insert(closed_.end(), told.begin(), told.end());
}

/// An answer is the last word for a client that cannot be asked to pull again.
LateFindings::Findings Session::findings_for_pull(OpenDocument& open, const Snapshot& snapshot) {
  if (!is_kept(Feature::Diagnostics)) return late_findings_.wait_for(snapshot);
  LateFindings::Findings findings = late_findings_.of(open.uri, snapshot);
  open.lacks_findings = findings == nullptr;
  return findings;
}

void Session::take_findings() {
  for (const std::string& fault : late_findings_.take_faults()) log_.error(fault);
  bool is_news = false;
  for (const std::string& uri : late_findings_.take_found()) {
    OpenDocument* const open = documents_.find(uri);
    if (open == nullptr || !open->lacks_findings) continue;
    const LateFindings::Findings findings = late_findings_.of(uri, open->document.snapshot());
    if (findings == nullptr) continue;  // the text has changed since
    open->lacks_findings = false;
    if (findings->is_silent()) continue;
    open->published = false;
    is_news = true;
  }
  if (is_news && is_kept(Feature::Diagnostics)) outbox_.request("workspace/diagnostic/refresh");
}

/// The id stands for the diagnostics themselves: an edit that changes none of them leaves the client's result good.
Session::Outcome Session::diagnostic(const PullParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const Snapshot& snapshot = open->document.snapshot();
  Positions places = positions(*open);
  const LateFindings::Findings findings = findings_for_pull(*open, snapshot);
  JsonWriter items;
  write_diagnostic_items(items, places, open->uri, as_set(features::diagnostics(snapshot, findings.get())),
                         diagnostic_style());
  if (open->pulled_id == 0 || open->pulled != items.text()) {
    open->pulled_id = ++last_result_;
    open->pulled = items.take();
  }
  const std::string id = std::to_string(open->pulled_id);
  const bool is_known = params.previous_result == id;
  result.begin_object();
  result.member("kind", is_known ? "unchanged" : "full");
  result.member("resultId", id);
  if (!is_known) {
    result.key("items");
    result.raw(open->pulled);
  }
  result.end_object();
  return std::nullopt;
}

}  // namespace texbrdf::lsp
