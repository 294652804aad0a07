#include "lsp/projects.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "files/follow_includes.h"
#include "source/internal_error.h"
#include "source/text_change.h"
#include "syntax/block_scanner.h"

namespace texbrdf::lsp {
namespace {

/// Files whose change no client has told of are noticed after so long, at the next question.
constexpr std::chrono::milliseconds kLookAgain{200};
/// A root is looked for among so many files.
constexpr std::size_t kMaxLookedInto = 200;
constexpr int kMaxClimb = 16;
/// What names the root stands at the beginning.
constexpr std::size_t kHeadBytes = 4096;

std::optional<std::string> named_root(std::string_view path, std::string_view head) {
  const std::optional<std::string> root = read_root(head);
  if (!root) return std::nullopt;
  const std::string named = root->starts_with('/') ? *root : files::folder_of(path) + "/" + *root;
  return files::real_path(named.ends_with(".tex") ? named : named + ".tex");
}

std::string head_of(const SourceText& text) {
  return text.slice({0, std::min<uint32_t>(text.size(), kHeadBytes)});
}

std::vector<IncludeTarget> includes_of(std::string_view bytes, TextLanguage language) {
  return Document(bytes, language).includes();
}

/// The LaTeX files of a folder, in the order of their names.
std::vector<std::string> latex_files(const std::string& folder) {
  std::vector<std::string> paths;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    if (entry->path().extension() == ".tex") paths.push_back(entry->path().string());
    if (paths.size() >= kMaxLookedInto) break;
  }
  std::ranges::sort(paths);
  return paths;
}

}  // namespace

std::optional<FileId> Project::find(std::string_view path) const {
  const auto found = std::ranges::find(paths, path);
  if (found == paths.end()) return std::nullopt;
  return FileId{static_cast<uint32_t>(found - paths.begin())};
}

void Projects::set_folders(std::span<const std::string> paths) {
  folders_.clear();
  for (const std::string& path : paths) folders_.push_back(files::real_path(path));
  disk_changed();
}

Buffer& Projects::open(std::string path, SourceText text, TextLanguage language) {
  buffers_.push_back(std::make_unique<Buffer>(
      Buffer{.path = std::move(path), .text = std::move(text), .file = {}, .language = language}));
  is_settled_ = false;
  return *buffers_.back();
}

void Projects::close(Buffer& buffer) {
  const std::string path = buffer.path;
  std::erase_if(buffers_, [&](const auto& kept) { return kept.get() == &buffer; });
  for (const auto& project : projects_) {
    if (const auto file = project->find(path)) project->stamps[file->value] = {};
  }
  disk_changed();
}

void Projects::replace(Buffer& buffer, Span span, std::string_view replacement) {
  const uint32_t begin = std::min(span.begin, buffer.text.size());
  const uint32_t end = std::clamp(span.end, begin, buffer.text.size());
  if (replacement.size() > SourceText::kMaxBytes - buffer.text.size()) return;
  const bool may_name_root = begin < kHeadBytes && !folders_.empty();
  const std::string head = may_name_root ? head_of(buffer.text) : std::string();
  buffer.text = buffer.text.with({begin, end}, replacement);
  if (!buffer.is_new) buffer.edits.push_back({{begin, end}, std::string(replacement)});
  if (may_name_root && read_root(head) != read_root(head_of(buffer.text))) is_settled_ = false;
}

void Projects::start_anew() {
  projects_.clear();
  known_.clear();
  for (const auto& buffer : buffers_) {
    buffer->home = nullptr;
    buffer->is_new = false;
    buffer->edits.clear();
  }
  disk_changed();
}

void Projects::disk_changed() {
  looked_ = {};
  roots_.clear();
  is_settled_ = false;
}

const Snapshot& Projects::snapshot(Buffer& buffer) {
  const bool has_others = buffer.home != nullptr && (buffer.home->paths.size() > 1 || !buffer.home->is_complete);
  if (has_others) look_at_disk();
  settle();
  require(buffer.home != nullptr, "a settled buffer has a home");
  return buffer.home->document.snapshot(buffer.file);
}

const Buffer* Projects::find_buffer(std::string_view path) const {
  for (const auto& buffer : buffers_) {
    if (buffer->path == path) return buffer.get();
  }
  return nullptr;
}

bool Projects::may_read(std::string_view path) const {
  if (find_buffer(path) != nullptr) return true;
  return std::ranges::any_of(folders_, [&](const std::string& folder) { return files::is_below(path, folder); });
}

bool Projects::exists(const std::string& path) const {
  return find_buffer(path) != nullptr || files::stamp_of(path).exists;
}

std::optional<SourceText> Projects::text(const std::string& path) {
  if (const Buffer* buffer = find_buffer(path)) return buffer->text;
  const std::optional<std::string> bytes = files::read_file(path);
  if (!bytes) return std::nullopt;
  return SourceText(*bytes);
}

TextLanguage Projects::language(const std::string& path) const {
  const Buffer* buffer = find_buffer(path);
  return buffer != nullptr ? buffer->language : language_of_path(path);
}

void Projects::take_texts(Buffer& buffer) {
  for (const features::TextEdit& edit : buffer.edits) take_edit(buffer, edit);
  buffer.edits.clear();
  if (!buffer.is_new) return;
  for (const auto& project : projects_) {
    const auto file = project->find(buffer.path);
    if (!file) continue;
    project->document.set_language(*file, buffer.language);
    project->document.set_text(*file, buffer.text.bytes());
  }
  buffer.is_new = false;
}

void Projects::take_edit(const Buffer& buffer, const features::TextEdit& edit) {
  for (const auto& project : projects_) {
    const bool is_home = project.get() == buffer.home;
    const std::optional<FileId> file = is_home ? buffer.file : project->find(buffer.path);
    if (!file) continue;
    project->document.replace(*file, edit.span, edit.text);
    const bool includes_others = project->document.includes(*file) != project->includes[file->value];
    if (includes_others) is_settled_ = false;
  }
}

void Projects::look_at_disk() {
  const auto now = std::chrono::steady_clock::now();
  if (looked_ != std::chrono::steady_clock::time_point{} && now - looked_ < kLookAgain) return;
  looked_ = now;
  for (const auto& project : projects_) {
    reread_changed(*project);
    if (!project->is_complete) is_settled_ = false;
  }
}

void Projects::reread_changed(Project& project) {
  for (uint32_t file = 0; file < project.paths.size(); ++file) {
    const std::string& path = project.paths[file];
    if (find_buffer(path) != nullptr) continue;
    const files::FileStamp stamp = files::stamp_of(path);
    if (stamp == project.stamps[file]) continue;
    project.stamps[file] = stamp;
    project.state = ++last_state_;
    is_settled_ = false;
    const std::optional<std::string> bytes = files::read_file(path);
    if (!bytes) continue;
    project.document.set_language({file}, language(path));
    project.document.set_text({file}, *bytes);
  }
}

void Projects::settle() {
  for (const auto& buffer : buffers_) take_texts(*buffer);
  if (is_settled_) return;
  look_at_disk();
  is_settled_ = true;
  for (const auto& project : projects_) follow(*project);
  find_homes();
  drop_unused();
  for (const auto& buffer : buffers_) buffer->file = *buffer->home->find(buffer->path);
}

void Projects::follow(Project& project) {
  const std::vector<std::string> before = project.paths;
  project.is_complete = files::follow_includes(project.document, project.paths, *this);
  std::vector<files::FileStamp> stamps;
  project.includes.clear();
  for (uint32_t file = 0; file < project.paths.size(); ++file) {
    const auto known = std::ranges::find(before, project.paths[file]);
    const bool was_read = known != before.end() && !project.stamps.empty();
    stamps.push_back(was_read ? project.stamps[static_cast<std::size_t>(known - before.begin())]
                              : files::stamp_of(project.paths[file]));
    project.includes.push_back(project.document.includes({file}));
  }
  project.stamps = std::move(stamps);
  if (project.paths != before || project.state == 0) project.state = ++last_state_;
}

/// A buffer belongs to the project of its root, where that includes it; else to one that includes it; else it is the
/// root of its own.
void Projects::find_homes() {
  for (const auto& buffer : buffers_) {
    Project* home = home_by_root(*buffer);
    buffer->home = home != nullptr ? home : project_of_root(buffer->path);
  }
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < buffers_.size(); ++i) {
    if (is_first_root(i)) roots.push_back(i);
  }
  for (const auto& buffer : buffers_) {
    if (buffer->home->paths.front() != buffer->path) continue;
    const auto root = std::ranges::find_if(roots, [&](std::size_t i) { return includes(*buffers_[i], *buffer); });
    if (root != roots.end()) buffer->home = buffers_[*root]->home;
  }
}

/// No other buffer includes it; of those that include each other, it was opened first.
bool Projects::is_first_root(std::size_t buffer) const {
  for (std::size_t i = 0; i < buffers_.size(); ++i) {
    const bool is_earlier = i < buffer || !includes(*buffers_[buffer], *buffers_[i]);
    if (i != buffer && is_earlier && includes(*buffers_[i], *buffers_[buffer])) return false;
  }
  return true;
}

bool Projects::includes(const Buffer& root, const Buffer& other) const {
  return root.home->paths.front() == root.path && root.home->find(other.path).has_value();
}

Project* Projects::home_by_root(const Buffer& buffer) {
  std::optional<std::string> root = named_root(buffer.path, head_of(buffer.text));
  if (!root) {
    auto found = roots_.find(buffer.path);
    if (found == roots_.end()) found = roots_.emplace(buffer.path, find_root(buffer.path)).first;
    root = found->second;
  }
  if (root->empty() || *root == buffer.path || !may_read(*root) || !exists(*root)) return nullptr;
  Project* project = project_of_root(*root);
  return project != nullptr && project->find(buffer.path) ? project : nullptr;
}

/// Empty where no file of the workspace includes this one.
std::string Projects::find_root(const std::string& path) {
  std::string root;
  std::string below = path;
  std::vector<std::string> seen;
  for (int climbed = 0; climbed < kMaxClimb; ++climbed) {
    seen.push_back(below);
    const std::string includer = find_includer(below);
    if (includer.empty() || std::ranges::find(seen, includer) != seen.end()) break;
    root = includer;
    if (const auto& named = look_into(includer).root) return *named;
    below = includer;
  }
  return root;
}

/// A file beside this one, or in a folder above it, that includes it.
std::string Projects::find_includer(const std::string& path) {
  if (!may_read(path)) return {};
  std::size_t looked_into = 0;
  for (std::string folder = files::folder_of(path); may_read(folder); folder = files::folder_of(folder)) {
    for (const std::string& found : latex_files(folder)) {
      const std::string candidate = files::real_path(found);
      if (candidate == path || !may_read(candidate)) continue;
      if (++looked_into > kMaxLookedInto) return {};
      for (const IncludeTarget& target : look_into(candidate).includes) {
        const files::ResolvedInclude resolved = files::resolve_include(target, candidate, candidate, *this);
        const auto* included = std::get_if<std::string>(&resolved);
        if (included != nullptr && *included == path) return candidate;
      }
    }
    if (folder == "/") break;
  }
  return {};
}

const Projects::KnownFile& Projects::look_into(const std::string& path) {
  KnownFile& known = known_[path];
  if (const Buffer* buffer = find_buffer(path)) {
    const std::string bytes = buffer->text.bytes();
    known = {{}, includes_of(bytes, buffer->language), named_root(path, std::string_view(bytes).substr(0, kHeadBytes))};
    return known;
  }
  const files::FileStamp stamp = files::stamp_of(path);
  if (known.stamp == stamp) return known;
  const std::string bytes = files::read_file(path).value_or(std::string());
  known = {stamp, includes_of(bytes, language_of_path(path)),
           named_root(path, std::string_view(bytes).substr(0, kHeadBytes))};
  return known;
}

/// nullptr where the root cannot be read.
Project* Projects::project_of_root(const std::string& root) {
  for (const auto& project : projects_) {
    if (project->paths.front() == root) return project.get();
  }
  const files::FileStamp stamp = files::stamp_of(root);
  std::optional<SourceText> bytes = text(root);
  if (!bytes) return nullptr;
  projects_.push_back(std::make_unique<Project>(Project{
      .document = Document(*std::move(bytes), language(root)), .paths = {root}, .stamps = {stamp}, .includes = {}}));
  follow(*projects_.back());
  return projects_.back().get();
}

void Projects::drop_unused() {
  std::erase_if(projects_, [&](const auto& project) {
    return std::ranges::none_of(buffers_, [&](const auto& buffer) { return buffer->home == project.get(); });
  });
}

void ProjectDocument::set_text(std::string_view text) {
  const std::string old = buffer_->text.bytes();
  const TextChange change = smallest_change(old, text);
  replace(change.span, change.replacement);
}

void ProjectDocument::prepare_for_edits() {
  snapshot();
  buffer_->home->document.prepare_for_edits();
}

}  // namespace texbrdf::lsp
