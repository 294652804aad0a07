// What the session does with scenes.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <variant>

#include "lsp/session.h"
#include "lsp/uri.h"
#include "lsp/write_frame_parts.h"
#include "render/base64.h"
#include "render/shader_complaint.h"
#include "scene_json/code_mistake.h"

namespace texbrdf::lsp {
namespace {

std::string_view view_word(render::SceneView view) {
  const auto entries = render::scene_view_entries();
  return std::ranges::find(entries, view, &render::SceneViewEntry::view)->word;
}

void write_frame(JsonWriter& out, const std::string& uri, const preview::SceneFrame& frame) {
  out.begin_object();
  out.member("preview", frame.preview);
  out.member("uri", uri);
  out.member("version", frame.version);
  out.member("source", "gpu");
  out.member("view", view_word(frame.view));
  write_samples(out, frame.samples, frame.all_samples);
  out.member("width", frame.width);
  out.member("height", frame.height);
  out.member("png", render::base64(frame.png));
  out.member("milliseconds", frame.milliseconds);
  write_bad_pixels(out, frame.bad_pixels);
  out.member("current", frame.is_current);
  out.end_object();
}

/// A mistake in code of a user as other mistakes are told, anything else as it was said.
std::string words_of(const preview::SceneTrouble& trouble, std::string_view folder) {
  const auto complaint = render::find_complaint(trouble.fault.message);
  if (!complaint) return trouble.fault.message;
  return scene_json::describe_code_mistake(*trouble.shader, complaint->source, complaint->line, complaint->message,
                                           folder)
      .value_or(trouble.fault.message);
}

void write_keys(JsonWriter& out, const ScenePreview& preview) {
  out.key("keys");
  out.begin_array();
  if (preview.seen) {
    for (const scene::Node& node : preview.seen->scene().nodes) {
      if (!node.dynamic || node.dynamic->keys.empty()) continue;
      out.begin_object();
      out.member("object", node.dynamic->name);
      out.key("keys");
      out.begin_array();
      for (const scene::KeyBinding& binding : node.dynamic->keys) out.value(binding.key);
      out.end_array();
      out.end_object();
    }
  }
  out.end_array();
}

}  // namespace

std::string Session::open_scene_document(const DidOpenParams& params) {
  OpenScene& open = scenes_.open(params.uri, params.text, params.version);
  open.touched = ++last_touch_;
  log_.debug(fmt::format("{} is open, a scene, version {}", shown_path(params.uri), params.version));
  return {};
}

std::string Session::change_scene_document(const DidChangeParams& params) {
  OpenScene& open = *scenes_.find(params.uri);
  for (const ContentChange& change : params.changes) scenes_.apply(change, unit_, open);
  open.version = params.version;
  open.touched = ++last_touch_;
  return {};
}

std::string Session::close_scene_document(const DocumentParams& params) {
  scenes_.close(params.uri);
  scene_previews_.close_all(params.uri);
  if (shows_scene_problems()) closed_.push_back(params.uri);
  return {};
}

void Session::write_scene_problems(JsonWriter& out, const SceneProblems& problems) {
  out.begin_object();
  out.member("uri", problems.uri);
  if (problems.version) out.member("version", *problems.version);
  out.key("diagnostics");
  out.raw(problems.items);
  out.end_object();
}

bool Session::answer_about_scene(std::string_view method, const nlohmann::json& params, JsonWriter& result) {
  if (!method.starts_with("textDocument/") || !params.is_object()) return false;
  const auto document = params.find("textDocument");
  if (document == params.end() || !document->is_object()) return false;
  const auto uri = document->find("uri");
  const bool is_scene =
      uri != document->end() && uri->is_string() && scenes_.find(uri->get_ref<const std::string&>()) != nullptr;
  if (!is_scene) return false;
  if (method == "textDocument/diagnostic") {
    result.raw(R"({"kind":"full","items":[]})");  // They are published.
  } else {
    result.null();
  }
  return true;
}

Session::Outcome Session::open_scene(const OpenSceneParams& params, JsonWriter& result) {
  OpenScene* const scene = scenes_.find(params.uri);
  if (scene == nullptr) return not_open(params.uri);
  if (previews_.are_many() || scene_previews_.are_many()) {
    return ResponseError{ErrorCode::RequestFailed, "too many previews are open"};
  }
  ScenePreview preview;
  preview.viewer = speaker_;
  preview.uri = params.uri;
  if (auto fault = scene_previews_.change(params.change, preview)) {
    return ResponseError{ErrorCode::InvalidParams, *std::move(fault)};
  }
  const int64_t id = previews_.take_id();
  scene_previews_.open(id, std::move(preview));
  result.begin_object();
  result.member("preview", id);
  result.key("views");
  result.begin_array();
  for (const render::SceneViewEntry& entry : render::scene_view_entries()) {
    result.begin_object();
    result.member("name", entry.word);
    result.member("meaning", entry.meaning);
    result.end_object();
  }
  result.end_array();
  result.end_object();
  return std::nullopt;
}

std::string Session::update_scene(const UpdateSceneParams& params) {
  ScenePreview* const preview = scene_previews_.find(params.preview, speaker_);
  if (preview == nullptr) return unknown_preview(params.preview);
  if (auto fault = scene_previews_.change(params.change, *preview)) return *std::move(fault);
  scene_previews_.show(params.preview, *preview);
  return {};
}

std::string Session::scene_input(const SceneInputParams& params) {
  ScenePreview* const preview = scene_previews_.find(params.preview, speaker_);
  if (preview == nullptr) return unknown_preview(params.preview);
  if (!preview->seen || !preview->seen->apply(params.input)) return {};
  preview->view = preview->seen->view();
  scene_previews_.show(params.preview, *preview);
  return {};
}

void Session::refresh_scene_previews() {
  if (scene_previews_.all().empty()) return;
  scenes_.settle();
  for (auto& [id, preview] : scene_previews_.all()) {
    const OpenScene* const scene = scenes_.find(preview.uri);
    if (scene == nullptr) continue;
    if (ScenePreviews::read(*scene, preview)) scene_previews_.show(id, preview);
    if (!preview.is_told) tell_scene_state(id, preview);
    preview.is_told = true;
  }
}

void Session::tell_scene_state(int64_t id, const ScenePreview& preview) {
  tell_viewer(preview.viewer, "texbrdf/previewState", [&](JsonWriter& out) {
    out.begin_object();
    out.member("preview", id);
    out.member("uri", preview.uri);
    out.member("version", preview.version);
    out.member("state", preview.problem.empty() ? "good" : "errors");
    out.member("message", preview.problem);
    write_keys(out, preview);
    out.end_object();
  });
}

void Session::send_scene_frames() {
  for (const preview::SceneEvent& event : scene_previews_.take_events()) {
    const auto id = std::visit([](const auto& told) { return told.preview; }, event);
    const auto found = scene_previews_.all().find(id);
    if (found == scene_previews_.all().end()) continue;
    ScenePreview& preview = found->second;
    if (const auto* frame = std::get_if<preview::SceneFrame>(&event)) {
      tell_viewer(preview.viewer, "texbrdf/frame", [&](JsonWriter& out) { write_frame(out, preview.uri, *frame); });
      continue;
    }
    const auto& trouble = std::get<preview::SceneTrouble>(event);
    log_.warning(trouble.fault.message);
    if (trouble.shader != preview.shader) continue;
    preview.is_rejected = trouble.fault.kind == render::RenderFaultKind::Shader;
    const OpenScene* const scene = scenes_.find(preview.uri);
    const std::string folder = scene == nullptr ? std::string() : files::folder_of(scene->path);
    preview.problem = words_of(trouble, folder);
    tell_scene_state(id, preview);
  }
}

}  // namespace texbrdf::lsp
