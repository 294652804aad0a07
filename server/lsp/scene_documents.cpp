#include "lsp/scene_documents.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "lsp/json_writer.h"
#include "lsp/uri.h"
#include "lsp/write_results.h"

namespace texbrdf::lsp {
namespace {

constexpr auto kEndings = std::to_array<std::string_view>(
    {".scene.json", ".model.json", ".material.json", ".shader.json", ".primitive.json"});
/// Files whose change no client has told of are noticed after so long, at the next question.
constexpr std::chrono::milliseconds kLookAgain{200};

/// Of documents the language's own diagnostics tell.
bool is_json(std::string_view path) {
  return path.ends_with(".json");
}

bool is_before(const scene_json::Problem* one, const scene_json::Problem* other) {
  return std::tie(one->span.begin, one->span.end, one->message) <
         std::tie(other->span.begin, other->span.end, other->message);
}

bool is_same(const scene_json::Problem* one, const scene_json::Problem* other) {
  return !is_before(one, other) && !is_before(other, one);
}

std::string written(std::vector<const scene_json::Problem*> problems, const SourceText& text, ColumnUnit unit) {
  std::ranges::sort(problems, is_before);
  const auto repeated = std::ranges::unique(problems, is_same);
  problems.erase(repeated.begin(), repeated.end());
  JsonWriter out;
  out.begin_array();
  for (const scene_json::Problem* problem : problems) {
    out.begin_object();
    write_range(out, "range", {text.position(problem->span.begin, unit), text.position(problem->span.end, unit)});
    out.member("severity", severity_number(problem->severity));
    out.member("source", "texbrdf");
    out.member("message", problem->message);
    out.end_object();
  }
  out.end_array();
  return out.take();
}

}  // namespace

bool is_scene_uri(std::string_view uri) {
  return std::ranges::any_of(kEndings, [&](std::string_view ending) { return uri.ends_with(ending); });
}

OpenScene& SceneDocuments::open(std::string uri, std::string_view text, int64_t version) {
  close(uri);
  OpenScene scene;
  scene.path = uri.starts_with("file:") ? files::real_path(shown_path(uri)) : uri;
  scene.uri = uri;
  scene.text = SourceText(text);
  scene.version = version;
  note_change(scene.path);
  return scenes_.emplace(std::move(uri), std::move(scene)).first->second;
}

bool SceneDocuments::close(std::string_view uri) {
  const auto found = scenes_.find(uri);
  if (found == scenes_.end()) return false;
  const std::string path = found->second.path;
  told_.erase(path);
  scenes_.erase(found);
  note_change(path);
  is_collected_ = false;
  return true;
}

void SceneDocuments::clear() {
  scenes_.clear();
  told_.clear();
  wanted_.clear();
}

OpenScene* SceneDocuments::find(std::string_view uri) {
  const auto found = scenes_.find(uri);
  return found == scenes_.end() ? nullptr : &found->second;
}

void SceneDocuments::apply(const ContentChange& change, ColumnUnit unit, OpenScene& open) {
  if (!change.range) {
    open.text = SourceText(change.text);
  } else {
    const uint32_t begin = open.text.offset(change.range->start, unit);
    const uint32_t end = open.text.offset(change.range->end, unit);
    if (change.text.size() > SourceText::kMaxBytes - open.text.size()) return;
    open.text = open.text.with({std::min(begin, end), std::max(begin, end)}, change.text);
  }
  open.is_published = false;
  note_change(open.path);
}

void SceneDocuments::note_change(std::string_view path) {
  for (auto& [uri, scene] : scenes_) {
    const bool depends =
        scene.path == path || !scene.read || std::ranges::find(scene.read->files, path) != scene.read->files.end();
    scene.is_stale = scene.is_stale || depends;
  }
}

void SceneDocuments::start_anew() {
  for (auto& [uri, scene] : scenes_) {
    scene.read = nullptr;
    scene.is_stale = true;
  }
  wanted_.clear();
  is_collected_ = false;
}

void SceneDocuments::settle() {
  look_at_disk();
  for (auto& [uri, scene] : scenes_) {
    if (!scene.is_stale) continue;
    scene.is_stale = false;
    scene.read = std::make_shared<const scene_json::LoadedScene>(scene_json::load_scene(scene.path, *this));
    scene.state = ++last_state_;
    scene.watch.watch(scene.read->files);
    is_collected_ = false;
  }
}

void SceneDocuments::look_at_disk() {
  const auto now = std::chrono::steady_clock::now();
  if (scenes_.empty() || now - looked_ < kLookAgain) return;
  looked_ = now;
  for (auto& [uri, scene] : scenes_) {
    if (scene.watch.has_changed()) scene.is_stale = true;
  }
}

void SceneDocuments::collect(ColumnUnit unit) {
  if (is_collected_) return;
  is_collected_ = true;
  std::map<std::string, std::vector<const scene_json::Problem*>> by_path;
  for (const auto& [uri, scene] : scenes_) {
    if (!scene.read) continue;
    for (const scene_json::Problem& problem : scene.read->problems) {
      if (is_json(problem.file)) by_path[problem.file].push_back(&problem);
    }
  }
  wanted_.clear();
  for (auto& [path, problems] : by_path) {
    wanted_[path] = written(std::move(problems), text(path).value_or(SourceText()), unit);
  }
}

bool SceneDocuments::has_problems_to_tell(ColumnUnit unit) {
  settle();
  collect(unit);
  return wanted_ != told_ || std::ranges::any_of(scenes_, [](const auto& entry) { return !entry.second.is_published; });
}

std::optional<SceneProblems> SceneDocuments::next_problems(ColumnUnit unit) {
  collect(unit);
  const auto tell = [&](const std::string& path) {
    const auto wanted = wanted_.find(path);
    if (wanted != wanted_.end()) told_[path] = wanted->second;
    if (wanted == wanted_.end()) told_.erase(path);
    for (auto& [uri, scene] : scenes_) {
      if (scene.path != path) continue;
      scene.is_published = true;
      return SceneProblems{uri, scene.version, wanted == wanted_.end() ? "[]" : wanted->second};
    }
    return SceneProblems{file_uri(path), std::nullopt, wanted == wanted_.end() ? "[]" : wanted->second};
  };
  for (const auto& [uri, scene] : scenes_) {
    if (!scene.is_published) return tell(scene.path);
  }
  for (const auto& [path, items] : wanted_) {
    const auto told = told_.find(path);
    if (told == told_.end() || told->second != items) return tell(path);
  }
  for (const auto& [path, items] : told_) {
    if (!wanted_.contains(path)) return tell(std::string(path));
  }
  return std::nullopt;
}

std::vector<std::string> SceneDocuments::forget_told() {
  std::vector<std::string> uris;
  for (const auto& [path, items] : told_) {
    const OpenScene* scene = find_path(path);
    uris.push_back(scene != nullptr ? scene->uri : file_uri(path));
  }
  told_.clear();
  for (auto& [uri, scene] : scenes_) scene.is_published = false;
  return uris;
}

const OpenScene* SceneDocuments::find_path(std::string_view path) const {
  for (const auto& [uri, scene] : scenes_) {
    if (scene.path == path) return &scene;
  }
  return nullptr;
}

bool SceneDocuments::may_read(std::string_view path) const {
  return others_.may_read(path) || std::ranges::any_of(scenes_, [&](const auto& entry) {
           return entry.second.path == path || files::is_below(path, files::folder_of(entry.second.path));
         });
}

bool SceneDocuments::exists(const std::string& path) const {
  return find_path(path) != nullptr || others_.exists(path);
}

std::optional<SourceText> SceneDocuments::text(const std::string& path) {
  if (const OpenScene* scene = find_path(path)) return scene->text;
  return others_.text(path);
}

}  // namespace texbrdf::lsp
