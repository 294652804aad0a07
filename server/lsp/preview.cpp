#include <fmt/format.h>

#include <variant>

#include "features/model_parameters.h"
#include "lsp/session.h"
#include "lsp/write_frame_parts.h"
#include "render/base64.h"

namespace texbrdf::lsp {
namespace {

/// Of parameters that are set in one preview.
constexpr std::size_t kMostValues = 10'000;

void write_value(JsonWriter& out, const features::ModelParameter& parameter) {
  out.key("value");
  out.begin_array();
  for (uint32_t i = 0; i < type_components(parameter.type); ++i) out.value(parameter.value[i]);
  out.end_array();
}

void write_parameter(JsonWriter& out, Positions& positions, std::string_view uri,
                     const features::ModelParameter& parameter) {
  out.begin_object();
  out.member("name", parameter.name);
  out.member("label", parameter.spelling);
  out.member("type", parameter.type == Type::Real ? "real" : "colour");
  write_value(out, parameter);
  out.member("low", parameter.low);
  out.member("high", parameter.high);
  out.key("location");
  write_location(out, positions, uri, parameter.literal);
  out.end_object();
}

void write_frame(JsonWriter& out, const std::string& uri, const preview::Frame& frame) {
  out.begin_object();
  out.member("preview", frame.preview);
  out.member("uri", uri);
  out.member("version", frame.version);
  out.member("source", frame.device == preview::Device::Cpu ? "cpu" : "gpu");
  out.member("width", frame.size);
  out.member("height", frame.size);
  out.member("png", render::base64(frame.png));
  out.member("milliseconds", frame.milliseconds);
  write_bad_pixels(out, frame.bad_pixels);
  out.member("current", frame.is_current);
  if (frame.all_samples > 0) write_samples(out, frame.samples, frame.all_samples);
  out.end_object();
}

void write_state(JsonWriter& out, const std::string& uri, const preview::SceneState& state) {
  out.begin_object();
  out.member("preview", state.preview);
  out.member("uri", uri);
  out.member("version", state.version);
  out.member("state", state.problem.empty() ? "good" : "errors");
  out.member("message", state.problem);
  out.end_object();
}

}  // namespace

Session::Outcome Session::open_preview(const OpenPreviewParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  if (previews_.are_many() || scene_previews_.are_many())
    return ResponseError{ErrorCode::RequestFailed, "too many previews are open"};
  OpenPreview preview{.viewer = kEditor, .uri = params.uri, .root = {}, .view = {}, .values = {}};
  if (auto fault = change(params.view, preview)) return ResponseError{ErrorCode::InvalidParams, *std::move(fault)};
  const Snapshot& snapshot = open->document.snapshot();
  result.begin_object();
  result.member("preview", previews_.open(preview));
  result.key("root");
  if (snapshot.find(snapshot.root_name())) result.value(snapshot.root_name());
  if (!snapshot.find(snapshot.root_name())) result.null();
  result.end_object();
  return std::nullopt;
}

std::optional<std::string> Session::change(const ViewChange& change, OpenPreview& preview) {
  if (auto fault = change_view(change, preview)) return fault;
  const auto may_read = [this](const std::string& path) { return documents_.projects().may_read(path); };
  return change_object(change.object, preview.uri, may_read, preview.object);
}

std::string Session::update_preview(const UpdatePreviewParams& params) {
  OpenPreview* const preview = previews_.find(params.preview);
  if (preview == nullptr) return unknown_preview(params.preview);
  if (auto fault = change(params.view, *preview)) return *std::move(fault);
  if (!preview->is_stale) show(params.preview, *preview);
  return {};
}

std::string Session::close_preview(const PreviewParams& params) {
  previews_.close(params.preview);
  scene_previews_.close(params.preview, speaker_);
  return {};
}

std::string Session::frame_shown(const PreviewParams& params) {
  previews_.acknowledge(params.preview);
  scene_previews_.acknowledge(params.preview, speaker_);
  return {};
}

std::string Session::set_parameter(const SetParameterParams& params) {
  OpenPreview* const preview = previews_.find(params.preview);
  if (preview == nullptr) return unknown_preview(params.preview);
  if (params.value) {
    const bool are_many = preview->values.size() >= kMostValues && !preview->values.contains(params.name);
    if (are_many) return "too many parameters";
    preview->values[params.name] = *params.value;
  } else {
    preview->values.erase(params.name);
  }
  preview->is_stale = true;
  return {};
}

Session::Outcome Session::parameters(const ModelParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const Snapshot& snapshot = open->document.snapshot();
  Positions places = positions(*open);
  result.begin_array();
  for (const features::ModelParameter& parameter : features::model_parameters(snapshot, params.root)) {
    write_parameter(result, places, params.uri, parameter);
  }
  result.end_array();
  return std::nullopt;
}

Session::Outcome Session::parameter_edit(const ParameterEditParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const Snapshot& snapshot = open->document.snapshot();
  const auto edits = features::parameter_edit(snapshot, params.name, params.value);
  if (!edits) {
    return ResponseError{ErrorCode::InvalidParams, fmt::format("`{}` is no parameter of this kind", params.name)};
  }
  Positions places = positions(*open);
  write_workspace_edit(result, places, by_file(*open, *edits), client_.versioned_edits);
  return std::nullopt;
}

Session::Outcome Session::roots(const ModelParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr && scenes_.find(params.uri) != nullptr) {
    result.raw(R"({"root":null,"candidates":[]})");
    return std::nullopt;
  }
  if (open == nullptr) return not_open(params.uri);
  const Snapshot& snapshot = open->document.snapshot();
  const std::string root = snapshot.root_name();
  result.begin_object();
  result.key("root");
  if (snapshot.find(root)) result.value(root);
  if (!snapshot.find(root)) result.null();
  result.key("candidates");
  result.begin_array();
  for (const std::string& name : features::brdf_names(snapshot)) result.value(name);
  result.end_array();
  result.end_object();
  return std::nullopt;
}

void Session::show(int64_t id, const OpenPreview& preview) {
  OpenDocument* open = documents_.find(preview.uri);
  if (open == nullptr) return;
  previews_.show(id, preview, open->document.snapshot(), open->version.value_or(0));
}

void Session::tell_viewer(ViewerId viewer, std::string_view method, const Outbox::WriteParams& write_params) {
  if (viewer == kEditor) return outbox_.notify(method, write_params);
  browsers_.notify(viewer, method, write_params);
}

void Session::refresh_previews() {
  for (auto& [id, preview] : previews_.all()) {
    if (!preview.is_stale) continue;
    preview.is_stale = false;
    ++preview.model;
    show(id, preview);
  }
  refresh_scene_previews();
}

void Session::send_frames() {
  for (const preview::Event& event : previews_.take_events()) {
    const auto id = std::visit([](const auto& told) { return told.preview; }, event);
    const OpenPreview* const preview = previews_.find_of_any(id);
    if (preview == nullptr) continue;
    if (const auto* frame = std::get_if<preview::Frame>(&event)) {
      tell_viewer(preview->viewer, "texbrdf/frame", [&](JsonWriter& out) { write_frame(out, preview->uri, *frame); });
    } else {
      const auto& state = std::get<preview::SceneState>(event);
      tell_viewer(preview->viewer, "texbrdf/previewState",
                  [&](JsonWriter& out) { write_state(out, preview->uri, state); });
    }
  }
  send_scene_frames();
  for (const std::string& fault : previews_.take_faults()) log_.warning(fault);
}

}  // namespace texbrdf::lsp
