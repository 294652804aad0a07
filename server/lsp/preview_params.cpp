#include "lsp/preview_params.h"

#include "lsp/params_reader.h"

namespace texbrdf::lsp {
namespace {

using nlohmann::json;
using Reader = ParamsReader;

double required_number(Reader& reader, json* parent, const char* name) {
  const std::optional<double> value = reader.number(parent, name);
  if (!value) reader.fail(fmt::format("`{}` has to be a number", name));
  return value.value_or(0);
}

std::optional<int64_t> pixels(Reader& reader, json* parent, const char* name) {
  if (Reader::optional(parent, name) == nullptr) return std::nullopt;
  return reader.natural(parent, name);
}

std::vector<double> numbers(Reader& reader, json* parent, const char* name) {
  std::vector<double> values;
  json* array = reader.array(parent, name);
  if (array == nullptr) return values;
  for (const json& element : *array) {
    if (element.is_number()) {
      values.push_back(element.get<double>());
    } else {
      reader.fail(fmt::format("`{}` has to be a list of numbers", name));
    }
  }
  return values;
}

ViewChange view_change(Reader& reader, json* object) {
  ViewChange change;
  change.width = pixels(reader, object, "width");
  change.height = pixels(reader, object, "height");
  if (Reader::optional(object, "root") != nullptr) change.root = reader.string(object, "root");
  json* light = Reader::optional(object, "light");
  change.theta = reader.number(light, "theta");
  change.phi = reader.number(light, "phi");
  change.zoom = reader.number(object, "zoom");
  change.exposure = reader.number(object, "exposure");
  change.gamma = reader.number(object, "gamma");
  change.object = read_object(reader, object);
  if (Reader::optional(object, "cosine") != nullptr) change.cosine = reader.boolean(object, "cosine");
  return change;
}

}  // namespace

std::string read_params(json& params, OpenPreviewParams& out) {
  Reader reader;
  json* object = reader.object_of(params);
  out.uri = reader.string(object, "uri");
  out.view = view_change(reader, object);
  return reader.problem();
}

std::string read_params(json& params, UpdatePreviewParams& out) {
  Reader reader;
  json* object = reader.object_of(params);
  out.preview = reader.integer(object, "preview");
  out.view = view_change(reader, object);
  return reader.problem();
}

std::string read_params(json& params, PreviewParams& out) {
  Reader reader;
  out.preview = reader.integer(reader.object_of(params), "preview");
  return reader.problem();
}

std::string read_params(json& params, SetParameterParams& out) {
  Reader reader;
  json* object = reader.object_of(params);
  out.preview = reader.integer(object, "preview");
  out.name = reader.string(object, "name");
  if (Reader::optional(object, "value") != nullptr) out.value = numbers(reader, object, "value");
  return reader.problem();
}

std::string read_params(json& params, ModelParams& out) {
  Reader reader;
  json* object = reader.object_of(params);
  out.uri = reader.string(object, "uri");
  out.root = Reader::text_or_empty(object, "root");
  return reader.problem();
}

std::string read_params(json& params, ParameterEditParams& out) {
  Reader reader;
  json* object = reader.object_of(params);
  out.uri = reader.string(object, "uri");
  out.name = reader.string(object, "name");
  out.value = numbers(reader, object, "value");
  return reader.problem();
}

std::string read_params(json& params, EmitParams& out) {
  Reader reader;
  json* object = reader.object_of(params);
  out.uri = reader.string(object, "uri");
  out.root = Reader::text_or_empty(object, "root");
  out.target = reader.string(object, "target");
  return reader.problem();
}

std::string read_params(json& params, ProbeParams& out) {
  Reader reader;
  json* object = reader.object_of(params);
  out.preview = reader.integer(object, "preview");
  out.place = {required_number(reader, object, "x"), required_number(reader, object, "y")};
  out.definition = Reader::text_or_empty(object, "definition");
  return reader.problem();
}

std::string read_params(json& params, PlotParams& out) {
  Reader reader;
  json* object = reader.object_of(params);
  out.preview = reader.integer(object, "preview");
  const std::string kind = reader.string(object, "kind");
  const std::optional<plots::View> view = kind == "cartesian" ? plots::View::ThetaO : plots::view_of(kind);
  if (!view) reader.fail("`kind` has to be cartesian, " + plots::view_words());
  out.view = view.value_or(out.view);
  out.theta_h = reader.number(object, "thetaH");
  out.theta_d = reader.number(object, "thetaD");
  out.phi_d = reader.number(object, "phiD");
  return reader.problem();
}

}  // namespace texbrdf::lsp
