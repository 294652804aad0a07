#include "lsp/scene_params.h"

#include "lsp/params_reader.h"

namespace texbrdf::lsp {
namespace {

using nlohmann::json;
using Reader = ParamsReader;

/// No hand presses more.
constexpr std::size_t kMostKeys = 100;

SceneChange scene_change(Reader& reader, json* object) {
  SceneChange change;
  if (Reader::optional(object, "width") != nullptr) change.width = reader.natural(object, "width");
  if (Reader::optional(object, "height") != nullptr) change.height = reader.natural(object, "height");
  if (Reader::optional(object, "view") != nullptr) change.view = reader.string(object, "view");
  change.exposure = reader.number(object, "exposure");
  change.gamma = reader.number(object, "gamma");
  return change;
}

std::vector<std::string> keys(Reader& reader, json* object, const char* name) {
  std::vector<std::string> keys = Reader::strings(Reader::optional(object, name));
  if (keys.size() > kMostKeys) reader.fail(fmt::format("`{}` has too many keys", name));
  return keys;
}

}  // namespace

std::string read_params(json& params, OpenSceneParams& out) {
  Reader reader;
  json* object = reader.object_of(params);
  out.uri = reader.string(object, "uri");
  out.change = scene_change(reader, object);
  return reader.problem();
}

std::string read_params(json& params, UpdateSceneParams& out) {
  Reader reader;
  json* object = reader.object_of(params);
  out.preview = reader.integer(object, "preview");
  out.change = scene_change(reader, object);
  return reader.problem();
}

std::string read_params(json& params, SceneInputParams& out) {
  Reader reader;
  json* object = reader.object_of(params);
  out.preview = reader.integer(object, "preview");
  const std::vector<std::string> held = keys(reader, object, "held");
  out.input.held = {held.begin(), held.end()};
  out.input.pressed = keys(reader, object, "pressed");
  out.input.seconds = reader.number(object, "seconds").value_or(0);
  json* drag = Reader::optional(object, "drag");
  out.input.drag_right = reader.number(drag, "right").value_or(0);
  out.input.drag_down = reader.number(drag, "down").value_or(0);
  out.input.wheel = reader.number(object, "wheel").value_or(0);
  return reader.problem();
}

}  // namespace texbrdf::lsp
