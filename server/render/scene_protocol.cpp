#include "render/scene_protocol.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/bytes.h"

namespace texbrdf::render {

namespace {

enum class LightKind : uint8_t { Directional, Point };

void put(ByteWriter& writer, const scene::Triple& triple) {
  for (const double value : triple) writer.put(value);
}

scene::Triple get_triple(ByteReader& reader) {
  scene::Triple triple;
  for (double& value : triple) value = reader.get<double>();
  return triple;
}

void put(ByteWriter& writer, const scene::Light& light) {
  if (const auto* directional = std::get_if<scene::DirectionalLight>(&light)) {
    writer.put(static_cast<uint8_t>(LightKind::Directional));
    put(writer, directional->direction);
    put(writer, directional->colour);
    return;
  }
  const auto& point = std::get<scene::PointLight>(light);
  writer.put(static_cast<uint8_t>(LightKind::Point));
  put(writer, point.position);
  put(writer, point.colour);
}

std::optional<scene::Light> get_light(ByteReader& reader) {
  const auto kind = reader.get<uint8_t>();
  const scene::Triple place = get_triple(reader);
  const scene::Triple colour = get_triple(reader);
  if (kind == static_cast<uint8_t>(LightKind::Directional)) return scene::DirectionalLight{place, colour};
  if (kind == static_cast<uint8_t>(LightKind::Point)) return scene::PointLight{place, colour};
  return std::nullopt;
}

void put(ByteWriter& writer, const SceneState& state) {
  put(writer, state.camera.position);
  put(writer, state.camera.target);
  put(writer, state.camera.up);
  writer.put(state.camera.field_of_view);
  writer.put(static_cast<uint32_t>(state.lights.size()));
  for (const scene::Light& light : state.lights) put(writer, light);
  put(writer, state.environment.background);
  put(writer, state.environment.ambient);
  writer.put(state.settings.max_steps);
  writer.put(state.settings.max_distance);
  writer.put(state.settings.surface_threshold);
  writer.put(std::span<const float>(state.frames));
}

std::optional<SceneState> get_state(ByteReader& reader) {
  SceneState state;
  state.camera.position = get_triple(reader);
  state.camera.target = get_triple(reader);
  state.camera.up = get_triple(reader);
  state.camera.field_of_view = reader.get<double>();
  const auto light_count = reader.get<uint32_t>();
  if (light_count > scene::kMaxLights) return std::nullopt;
  for (uint32_t i = 0; i < light_count; ++i) {
    const auto light = get_light(reader);
    if (!light) return std::nullopt;
    state.lights.push_back(*light);
  }
  state.environment.background = get_triple(reader);
  state.environment.ambient = get_triple(reader);
  state.settings.max_steps = reader.get<uint32_t>();
  state.settings.max_distance = reader.get<double>();
  state.settings.surface_threshold = reader.get<double>();
  state.frames = reader.get_list<float>();
  return state;
}

void put(ByteWriter& writer, const SceneLook& look) {
  writer.put(static_cast<uint8_t>(look.view));
  writer.put(static_cast<uint8_t>(look.shadows));
  writer.put(look.light_size);
  writer.put(static_cast<uint8_t>(look.occlusion));
  writer.put(look.occlusion_radius);
}

std::optional<SceneLook> get_look(ByteReader& reader) {
  const auto view = reader.get<uint8_t>();
  const auto shadows = reader.get<uint8_t>();
  if (view >= scene_view_entries().size() || shadows > static_cast<uint8_t>(Shadows::Soft)) return std::nullopt;
  SceneLook look{static_cast<SceneView>(view), static_cast<Shadows>(shadows)};
  look.light_size = reader.get<double>();
  look.occlusion = reader.get<uint8_t>() != 0;
  look.occlusion_radius = reader.get<double>();
  return look;
}

void put(ByteWriter& writer, const SceneTile& tile) {
  for (const uint32_t value : {tile.picture_width, tile.picture_height, tile.x, tile.y, tile.width, tile.height}) {
    writer.put(value);
  }
}

SceneTile get_tile(ByteReader& reader) {
  SceneTile tile;
  for (uint32_t* value : {&tile.picture_width, &tile.picture_height, &tile.x, &tile.y, &tile.width, &tile.height}) {
    *value = reader.get<uint32_t>();
  }
  return tile;
}

void put(ByteWriter& writer, const SceneSample& sample) {
  for (const float value : {sample.pixel[0], sample.pixel[1], sample.ambient[0], sample.ambient[1]}) writer.put(value);
}

std::optional<SceneSample> get_sample(ByteReader& reader) {
  SceneSample sample;
  for (float* value : {&sample.pixel[0], &sample.pixel[1], &sample.ambient[0], &sample.ambient[1]}) {
    *value = reader.get<float>();
    if (!(*value >= 0 && *value < 1)) return std::nullopt;
  }
  return sample;
}

Message finish(MessageKind kind, ByteWriter& writer) {
  return {static_cast<uint32_t>(kind), writer.take()};
}

}  // namespace

Message encode(const SceneRequest& request) {
  ByteWriter writer;
  writer.put(std::string_view(request.source));
  put(writer, request.state);
  put(writer, request.look);
  put(writer, request.tile);
  put(writer, request.sample);
  return finish(MessageKind::SceneRequest, writer);
}

Message encode(const SceneAnswer& answer) {
  ByteWriter writer;
  writer.put(std::span<const float>(answer.values));
  writer.put(answer.milliseconds);
  writer.put(static_cast<uint8_t>(answer.compiled));
  return finish(MessageKind::SceneAnswer, writer);
}

template <>
std::optional<SceneRequest> decode(const Message& message) {
  if (message.kind != static_cast<uint32_t>(MessageKind::SceneRequest)) return std::nullopt;
  ByteReader reader(message.payload);
  SceneRequest request;
  request.source = reader.get_text();
  auto state = get_state(reader);
  if (!state) return std::nullopt;
  request.state = *std::move(state);
  const auto look = get_look(reader);
  if (!look) return std::nullopt;
  request.look = *look;
  request.tile = get_tile(reader);
  const auto sample = get_sample(reader);
  if (!sample || !reader.complete()) return std::nullopt;
  request.sample = *sample;
  return request;
}

template <>
std::optional<SceneAnswer> decode(const Message& message) {
  if (message.kind != static_cast<uint32_t>(MessageKind::SceneAnswer)) return std::nullopt;
  ByteReader reader(message.payload);
  SceneAnswer answer;
  answer.values = reader.get_list<float>();
  answer.milliseconds = reader.get<double>();
  answer.compiled = reader.get<uint8_t>() != 0;
  if (!reader.complete() || !(answer.milliseconds >= 0)) return std::nullopt;
  return answer;
}

std::optional<std::string> find_fault(const SceneRequest& request) {
  if (auto fault = find_fault(request.state)) return fault;
  if (auto fault = find_fault(request.look)) return fault;
  return find_fault(request.tile);
}

}  // namespace texbrdf::render
