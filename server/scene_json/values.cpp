#include "scene_json/values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/keys.h"

namespace texbrdf::scene_json {
namespace {

bool is_zero(const scene::Triple& vector) {
  return std::ranges::all_of(vector, [](double number) { return number == 0; });
}

void vector_member(FileReader& reader, ObjectReader& object, std::string_view key, scene::Triple& out) {
  if (const auto id = object.member(key)) out = read_vector(reader, *id).value_or(out);
}

void colour_member(FileReader& reader, ObjectReader& object, std::string_view key, scene::Triple& out) {
  if (const auto id = object.member(key)) out = read_colour(reader, *id).value_or(out);
}

std::optional<scene::Light> read_light(FileReader& reader, JsonId id) {
  ObjectReader object(reader, id);
  const auto type_id = object.required("type");
  const auto type = type_id ? reader.text(*type_id) : std::nullopt;
  if (!type) return std::nullopt;
  if (*type == "directional") {
    scene::DirectionalLight light;
    const auto direction = object.required("direction");
    if (direction) light.direction = read_vector(reader, *direction).value_or(light.direction);
    if (is_zero(light.direction)) reader.fail(*direction, "a direction is not zero");
    colour_member(reader, object, "colour", light.colour);
    object.finish();
    return light;
  }
  if (*type == "point") {
    scene::PointLight light;
    const auto position = object.required("position");
    if (position) light.position = read_vector(reader, *position).value_or(light.position);
    colour_member(reader, object, "colour", light.colour);
    object.finish();
    return light;
  }
  reader.fail(*type_id, fmt::format("`{}` is no light: there are `directional` and `point`", *type));
  return std::nullopt;
}

}  // namespace

std::optional<scene::Triple> read_vector(FileReader& reader, JsonId id) {
  ObjectReader object(reader, id);
  scene::Triple vector{};
  bool is_whole = object.valid();
  constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto member = object.required(kAxes[axis]);
    const auto number = member ? reader.number(*member) : std::nullopt;
    is_whole = is_whole && number.has_value();
    vector[axis] = number.value_or(0);
  }
  object.finish();
  if (!is_whole) return std::nullopt;
  return vector;
}

std::optional<scene::Triple> read_colour(FileReader& reader, JsonId id) {
  const auto numbers = reader.numbers(id, 3, 3);
  if (!numbers) return std::nullopt;
  if (std::ranges::any_of(*numbers, [](double number) { return number < 0; })) {
    reader.fail(id, "a colour has no negative component");
    return std::nullopt;
  }
  return scene::Triple{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

scene::Transform read_transform(FileReader& reader, JsonId id) {
  scene::Transform transform;
  ObjectReader object(reader, id);
  vector_member(reader, object, "position", transform.position);
  vector_member(reader, object, "rotation", transform.rotation);
  if (const auto scale = object.member("scale")) {
    transform.scale = read_vector(reader, *scale).value_or(transform.scale);
    const bool is_flat = std::ranges::any_of(transform.scale, [](double factor) { return factor == 0; });
    if (is_flat) reader.fail(*scale, "no factor of a scale is 0");
  }
  object.finish();
  return transform;
}

scene::Camera read_camera(FileReader& reader, JsonId id) {
  scene::Camera camera;
  const uint32_t errors = reader.error_count();
  ObjectReader object(reader, id);
  vector_member(reader, object, "position", camera.position);
  vector_member(reader, object, "target", camera.target);
  vector_member(reader, object, "up", camera.up);
  if (const auto angle = object.member("field_of_view")) {
    camera.field_of_view = reader.number(*angle, 1, 179).value_or(camera.field_of_view);
  }
  object.finish();
  if (reader.error_count() != errors) return camera;
  scene::Triple view{};
  for (std::size_t i = 0; i < 3; ++i) view[i] = camera.target[i] - camera.position[i];
  const scene::Triple side{view[1] * camera.up[2] - view[2] * camera.up[1],
                           view[2] * camera.up[0] - view[0] * camera.up[2],
                           view[0] * camera.up[1] - view[1] * camera.up[0]};
  if (is_zero(view)) reader.fail(id, "the camera stands in its target");
  if (!is_zero(view) && is_zero(side)) reader.fail(id, "the camera looks along `up`, or `up` is zero");
  return camera;
}

std::vector<scene::Light> read_lights(FileReader& reader, JsonId id) {
  std::vector<scene::Light> lights;
  const std::span<const JsonId> list = reader.list(id);
  if (list.size() > scene::kMaxLights) {
    reader.fail(id, fmt::format("a scene has at most {} lights, here are {}", scene::kMaxLights, list.size()));
    return lights;
  }
  for (const JsonId each : list) {
    if (const auto light = read_light(reader, each)) lights.push_back(*light);
  }
  return lights;
}

scene::Environment read_environment(FileReader& reader, JsonId id) {
  scene::Environment environment;
  ObjectReader object(reader, id);
  colour_member(reader, object, "background", environment.background);
  colour_member(reader, object, "ambient", environment.ambient);
  object.finish();
  return environment;
}

scene::RenderSettings read_settings(FileReader& reader, JsonId id) {
  scene::RenderSettings settings;
  ObjectReader object(reader, id);
  if (const auto steps = object.member("max_steps")) {
    settings.max_steps = static_cast<uint32_t>(reader.whole(*steps, 1, 10'000).value_or(settings.max_steps));
  }
  if (const auto distance = object.member("max_distance")) {
    settings.max_distance = reader.number(*distance, 1e-3, 1e6).value_or(settings.max_distance);
  }
  if (const auto threshold = object.member("surface_threshold")) {
    settings.surface_threshold = reader.number(*threshold, 1e-7, 1).value_or(settings.surface_threshold);
  }
  object.finish();
  return settings;
}

std::vector<scene::KeyBinding> read_keys(FileReader& reader, JsonId id) {
  std::vector<scene::KeyBinding> keys;
  if (!reader.expect(id, JsonKind::Object)) return keys;
  for (const JsonId each : reader[id].elements) {
    scene::KeyBinding binding{reader[each].key, {}, {}};
    if (!scene::is_key_name(binding.key)) {
      const std::vector<std::string> names(scene::key_names().begin(), scene::key_names().end());
      reader.fail_key(id, reader[each],
                      fmt::format("`{}` is no key: keys are written as `I`, `LEFT`, `KP_ADD`{}", binding.key,
                                  suggestion(binding.key, names)));
    }
    ObjectReader object(reader, each);
    vector_member(reader, object, "velocity", binding.velocity);
    vector_member(reader, object, "turning", binding.turning);
    object.finish();
    keys.push_back(std::move(binding));
  }
  return keys;
}

}  // namespace texbrdf::scene_json
