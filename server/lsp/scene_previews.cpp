#include "lsp/scene_previews.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace texbrdf::lsp {
namespace {

constexpr int64_t kMinSize = 16;
constexpr int64_t kMaxSize = 2048;
constexpr std::size_t kMany = 256;

uint32_t bounded_size(int64_t pixels) {
  return static_cast<uint32_t>(std::clamp(pixels, kMinSize, kMaxSize));
}

std::string problem_of(const scene_json::LoadedScene& read, const std::string& own_path) {
  const auto found = std::ranges::find(read.problems, Severity::Error, &scene_json::Problem::severity);
  if (found == read.problems.end()) return "the scene cannot be read";
  if (found->file == own_path) return fmt::format("line {}: {}", found->line, found->message);
  return scene_json::describe(*found, files::folder_of(own_path));
}

std::optional<uint32_t> view_of(std::string_view word) {
  const auto entries = render::scene_view_entries();
  const auto found = std::ranges::find(entries, word, &render::SceneViewEntry::word);
  if (found == entries.end()) return std::nullopt;
  return static_cast<uint32_t>(found - entries.begin());
}

}  // namespace

bool ScenePreviews::are_many() const {
  return previews_.size() >= kMany;
}

void ScenePreviews::open(int64_t id, ScenePreview preview) {
  if (!painter_ && wake_) painter_ = std::make_unique<preview::ScenePainter>(wake_);
  previews_.emplace(id, std::move(preview));
}

ScenePreview* ScenePreviews::find(int64_t id, ViewerId viewer) {
  const auto found = previews_.find(id);
  return found == previews_.end() || found->second.viewer != viewer ? nullptr : &found->second;
}

template <typename Condition>
void ScenePreviews::close_where(const Condition& condition) {
  std::erase_if(previews_, [&](const auto& entry) {
    if (!condition(entry.first, entry.second)) return false;
    if (painter_) painter_->close(entry.first);
    return true;
  });
}

void ScenePreviews::close(int64_t id, ViewerId viewer) {
  close_where([&](int64_t each, const ScenePreview& preview) { return each == id && preview.viewer == viewer; });
}

void ScenePreviews::close_all(std::string_view uri) {
  close_where([&](int64_t, const ScenePreview& preview) { return preview.uri == uri; });
}

void ScenePreviews::close_all_of(ViewerId viewer) {
  close_where([&](int64_t, const ScenePreview& preview) { return preview.viewer == viewer; });
}

void ScenePreviews::clear() {
  close_where([](int64_t, const ScenePreview&) { return true; });
}

std::optional<std::string> ScenePreviews::change(const SceneChange& change, ScenePreview& preview) {
  render::SceneDisplay display = preview.display;
  display.exposure = change.exposure.value_or(display.exposure);
  display.gamma = change.gamma.value_or(display.gamma);
  if (auto fault = render::find_fault(display)) return fault;
  const std::optional<uint32_t> view = change.view ? view_of(*change.view) : preview.view;
  if (!view) return fmt::format("there is no view `{}`", *change.view);
  preview.display = display;
  preview.view = *view;
  if (preview.seen) preview.seen->show_view(*view);
  if (change.width) preview.width = bounded_size(*change.width);
  if (change.height) preview.height = bounded_size(*change.height);
  return std::nullopt;
}

bool ScenePreviews::read(const OpenScene& scene, ScenePreview& preview) {
  preview.version = scene.version.value_or(0);
  if (!scene.read || preview.state == scene.state) return false;
  preview.state = scene.state;
  preview.is_told = false;
  preview.is_rejected = false;
  preview.problem = scene.read->scene ? std::string() : problem_of(*scene.read, scene.path);
  if (!scene.read->scene) return false;
  preview.shader = std::make_shared<const scene::SceneShader>(make_scene_shader(*scene.read->scene));
  if (preview.seen) {
    preview.seen->reload(*scene.read->scene);
  } else {
    preview.seen.emplace(*scene.read->scene);
    preview.seen->show_view(preview.view);
  }
  return true;
}

void ScenePreviews::show(int64_t id, const ScenePreview& preview) {
  if (!painter_ || !preview.seen || preview.is_rejected) return;
  const scene::Scene& scene = preview.seen->scene();
  preview::SceneShot shot{.shader = preview.shader,
                          .state = {scene.camera, scene.lights, scene.environment, scene.settings, scene_frames(scene)},
                          .look = {},
                          .display = preview.display,
                          .width = preview.width,
                          .height = preview.height,
                          .version = preview.version,
                          .is_current = preview.problem.empty()};
  shot.look.view = render::scene_view_entries()[preview.seen->view()].view;
  painter_->show(id, std::move(shot));
}

void ScenePreviews::acknowledge(int64_t id, ViewerId viewer) {
  if (painter_ && find(id, viewer) != nullptr) painter_->acknowledge(id);
}

std::vector<preview::SceneEvent> ScenePreviews::take_events() {
  return painter_ ? painter_->take_events() : std::vector<preview::SceneEvent>();
}

}  // namespace texbrdf::lsp
