#include "lsp/object_params.h"

#include <cmath>

#include "files/file_source.h"
#include "lsp/params_reader.h"
#include "lsp/uri.h"

namespace texbrdf::lsp {
namespace {

using nlohmann::json;

constexpr int64_t kMostSamples = 65'536;

std::optional<double> number(ParamsReader& reader, json* parent, const char* name) {
  const json* value = ParamsReader::optional(parent, name);
  if (value == nullptr) return std::nullopt;
  if (value->is_number()) return value->get<double>();
  reader.fail(fmt::format("`{}` has to be a number", name));
  return std::nullopt;
}

std::optional<std::string> text(ParamsReader& reader, json* parent, const char* name) {
  if (ParamsReader::optional(parent, name) == nullptr) return std::nullopt;
  return reader.string(parent, name);
}

/// A word that is one of the program's own, or else the real path of a file; `problem` is why there may be none.
void change_name(const std::optional<std::string>& name, std::initializer_list<const char*> own,
                 std::string_view extension, const std::string& document_uri,
                 const std::function<bool(const std::string&)>& may_read, std::string& to, std::string& problem) {
  if (!name) return;
  problem.clear();
  to = *name;
  if (std::ranges::find(own, *name) != own.end()) return;
  if (!name->ends_with(extension)) {
    problem = fmt::format("'{}' is no file *{}", *name, extension);
    return;
  }
  const std::string folder = name->starts_with('/') ? "" : files::folder_of(shown_path(document_uri)) + "/";
  const std::string path = files::real_path(folder + *name);
  if (path.empty() || !may_read(path)) {
    problem = fmt::format("{} is in no folder that is open", *name);
  } else {
    to = path;
  }
}

}  // namespace

ObjectChange read_object(ParamsReader& reader, json* params) {
  if (ParamsReader::optional(params, "object") == nullptr) return {};
  json* object = reader.object(params, "object");
  ObjectChange change;
  change.shape = text(reader, object, "shape");
  change.light = text(reader, object, "light");
  change.yaw = number(reader, object, "yaw");
  change.pitch = number(reader, object, "pitch");
  if (ParamsReader::optional(object, "samples") != nullptr) change.samples = reader.integer(object, "samples");
  json* sun = ParamsReader::optional(object, "sun");
  change.elevation = number(reader, sun, "elevation");
  change.azimuth = number(reader, sun, "azimuth");
  change.turbidity = number(reader, object, "turbidity");
  return change;
}

std::optional<std::string> change_object(const ObjectChange& change, const std::string& document_uri,
                                         const std::function<bool(const std::string&)>& may_read,
                                         preview::ObjectLook& look) {
  preview::ObjectLook changed = look;
  change_name(change.shape, {"sphere", "teapot"}, ".obj", document_uri, may_read, changed.shape, changed.shape_problem);
  change_name(change.light, {"directional", "sky", "furnace"}, ".hdr", document_uri, may_read, changed.light.light,
              changed.light_problem);
  changed.orbit = {change.yaw.value_or(look.orbit.yaw), change.pitch.value_or(look.orbit.pitch)};
  if (!(std::abs(changed.orbit.yaw) <= 1e6 && std::abs(changed.orbit.pitch) <= 1e6)) {
    return "`yaw` and `pitch` are angles in degrees";
  }
  const int64_t samples = change.samples.value_or(look.samples);
  if (samples < 1 || samples > kMostSamples) return fmt::format("`samples` is 1 to {}", kMostSamples);
  changed.samples = static_cast<uint32_t>(samples);
  lighting::Sky& sky = changed.light.sky;
  sky = {change.elevation.value_or(sky.elevation), change.azimuth.value_or(sky.azimuth),
         change.turbidity.value_or(sky.turbidity)};
  if (auto fault = find_fault(sky)) return fault;
  look = changed;
  return std::nullopt;
}

}  // namespace texbrdf::lsp
