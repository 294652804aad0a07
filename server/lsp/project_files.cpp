#include <algorithm>
#include <utility>

#include "lsp/session.h"
#include "lsp/uri.h"

namespace texbrdf::lsp {

/// After the document's snapshot was asked for.
Positions Session::positions(OpenDocument& open) {
  return {open.document.present_snapshot(), unit_, [this, &open](FileId file) { return uri_of(open, file); }};
}

std::string Session::uri_of(const OpenDocument& open, FileId file) {
  const std::string& path = open.document.project().paths[file.value];
  const OpenDocument* other = documents_.find_path(path);
  return other != nullptr ? other->uri : file_uri(path);
}

/// In the order in which the files are first met.
std::vector<FileEdits> Session::by_file(OpenDocument& open, std::span<const features::TextEdit> edits) {
  const Snapshot& snapshot = open.document.present_snapshot();
  std::map<FileId, std::size_t> known;
  std::vector<FileEdits> files;
  for (const features::TextEdit& edit : edits) {
    const FileId file = snapshot.place(edit.span).file;
    const auto [found, is_new] = known.emplace(file, files.size());
    if (is_new) {
      const OpenDocument* edited = documents_.find_path(open.document.project().paths[file.value]);
      files.push_back({uri_of(open, file), edited != nullptr ? edited->version : std::nullopt, {}});
    }
    files[found->second].edits.push_back(edit);
  }
  return files;
}

/// Files that came, went or were read anew may change the diagnostics of all others in their projects.
void Session::notice_projects() {
  Projects& projects = documents_.projects();
  projects.settle();
  if (projects.last_state() == seen_state_) return;
  seen_state_ = projects.last_state();
  previews_.note_change();
  for (auto& [uri, open] : documents_.all()) {
    const uint64_t state = open.document.project().state;
    if (open.shown_state != 0 && open.shown_state != state) open.published = false;
  }
  forget_elsewhere();
}

/// An edit may change the diagnostics of other files of the project; only those that do change are published.
void Session::show_elsewhere(OpenDocument& open, std::span<const std::vector<features::ShownDiagnostic>> by_file) {
  const Project& project = open.document.project();
  open.shown_state = project.state;
  if (by_file.size() == 1) return;
  Positions places = positions(open);
  for (uint32_t file = 0; file < by_file.size(); ++file) {
    const std::string& path = project.paths[file];
    JsonWriter written;
    write_diagnostic_items(written, places, open.uri, by_file[file], diagnostic_style());
    std::string items = written.take();
    if (OpenDocument* other = documents_.find_path(path)) {
      const bool is_shown = other->published && &other->document.project() == &project;
      if (is_shown && other != &open && other->items != items) other->published = false;
      other->items = std::move(items);
    } else if (shown_elsewhere_.contains(path) ? shown_elsewhere_[path] != items : items != "[]") {
      shown_elsewhere_[path] = std::move(items);
      if (std::ranges::find(elsewhere_, path) == elsewhere_.end()) elsewhere_.push_back(path);
    }
  }
}

/// What was shown of files that are in no project any more is taken away.
void Session::forget_elsewhere() {
  for (auto shown = shown_elsewhere_.begin(); shown != shown_elsewhere_.end();) {
    const std::string& path = shown->first;
    const bool is_open = documents_.find_path(path) != nullptr;
    const bool is_kept = std::ranges::any_of(
        documents_.all(), [&](auto& entry) { return entry.second.document.project().find(path).has_value(); });
    if (is_kept && !is_open) {
      ++shown;
      continue;
    }
    std::erase(elsewhere_, path);
    if (!is_open && pushes_diagnostics()) closed_.push_back(file_uri(path));
    shown = shown_elsewhere_.erase(shown);
  }
}

}  // namespace texbrdf::lsp
