#include "scene_json/part_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/user_code.h"
#include "scene_json/property_text.h"
#include "semantics/names.h"

namespace texbrdf::scene_json {
namespace {

constexpr std::size_t kMaxModelsInside = 32;
constexpr std::size_t kMaxProperties = 64;

bool is_document(std::string_view path) {
  return path.ends_with(".tex") || path.ends_with(".md");
}

/// Where the code stands, if its lines are lines of the file.
scene::CodePlace place_of(const JsonFile& file, JsonId id) {
  const JsonValue& value = file.tree[id];
  const std::string written = file.text.slice(value.span);
  const auto breaks = std::ranges::count(written, '\n');
  const bool same_lines = value.kind == JsonKind::String && breaks == std::ranges::count(value.text, '\n');
  const uint32_t line = file.text.position(value.span.begin, ColumnUnit::CodePoint).line + 1;
  return {file.path, file.tree.path(id), same_lines ? line : 0};
}

/// At the line of the code where the file has it as a line, else at the code.
void fail_code(FileReader& reader, Problems& problems, JsonId code, const scene::CodePlace& place,
               const scene::CodeFault& fault) {
  const JsonValue& value = reader[code];
  if (value.kind == JsonKind::Array && fault.line < value.elements.size())
    return reader.fail(value.elements[fault.line], fault.message);
  if (place.first_line == 0) return reader.fail(code, fault.message);
  const std::string text = reader.file().text.slice(value.span);
  std::size_t begin = 0;
  for (uint32_t line = 0; line < fault.line; ++line) begin = text.find('\n', begin) + 1;
  const std::size_t end = std::min(text.find('\n', begin), text.size());
  const Span span{static_cast<uint32_t>(value.span.begin + begin), static_cast<uint32_t>(value.span.begin + end)};
  problems.add(reader.file().path, reader.file().text, reader.file().tree.path(code), span, fault.message);
}

template <typename Container>
bool is_full(FileReader& reader, JsonId id, const Container& parts, std::size_t most, std::string_view noun) {
  if (parts.size() < most) return false;
  reader.fail(id, fmt::format("a scene has at most {} {}s", most, noun));
  return true;
}

/// The numbers of a value in any of its spellings; nothing, and reported, where it is none.
std::optional<std::vector<double>> numbers_of(FileReader& reader, JsonId id) {
  const JsonValue& value = reader[id];
  if (value.kind == JsonKind::Array) return reader.numbers(id, 1, 3);
  if (value.kind == JsonKind::String) {
    auto numbers = read_tuple(value.text);
    if (!numbers)
      reader.fail(id, fmt::format("`{}` is neither a number nor several as in \"(0.5, 0.1, 0.5)\"", value.text));
    return numbers;
  }
  const auto number = reader.number(id);
  if (!number) return std::nullopt;
  return std::vector<double>{*number};
}

}  // namespace

Scope PartReader::scope(FileReader& reader, ObjectReader& object) {
  Scope scope = read_scope(reader, object, table_);
  const auto all = [&](PartKind kind, auto&& read) {
    for (const auto& part : scope.parts[static_cast<std::size_t>(kind)]) {
      if (part) read(part->where);
    }
  };
  all(PartKind::Primitive, [&](const Origin& part) { primitive(part); });
  all(PartKind::Shader, [&](const Origin& part) { shader(part); });
  all(PartKind::Material, [&](const Origin& part) { material(part); });
  all(PartKind::Model, [&](const Origin& part) { model(part); });
  return scope;
}

std::optional<scene::UserPrimitiveId> PartReader::primitive(const Origin& part) {
  if (const auto known = primitives_.find(part); known != primitives_.end()) return known->second;
  return primitives_[part] = read_primitive(part);
}

std::optional<scene::ShaderId> PartReader::shader(const Origin& part) {
  if (const auto known = shaders_.find(part); known != shaders_.end()) return known->second;
  return shaders_[part] = read_shader(part);
}

std::optional<scene::MaterialId> PartReader::material(const Origin& part) {
  if (const auto known = materials_.find(part); known != materials_.end()) return known->second;
  return materials_[part] = read_material(part);
}

std::optional<scene::UserPrimitiveId> PartReader::read_primitive(const Origin& part) {
  FileReader reader(*part.file, problems_);
  const uint32_t errors = reader.error_count();
  ObjectReader object(reader, part.id);
  object.member("$schema");
  scene::UserPrimitive primitive;
  if (const auto id = object.required("id")) {
    const auto number = reader.whole(*id, scene::kFirstUserPrimitive, INT32_MAX);
    primitive.id = static_cast<uint32_t>(number.value_or(scene::kFirstUserPrimitive));
    const auto [other, is_new] = primitive_ids_.try_emplace(primitive.id, part);
    if (number && !is_new) {
      reader.fail(
          *id, fmt::format("the primitive {} of {} has the id {} too", name_of_part(other->second, PartKind::Primitive),
                           FileTable::shown(other->second.file->path, *part.file), primitive.id));
    }
  }
  if (const auto id = object.required("code")) {
    primitive.code = read_code(reader, *id).value_or(std::string());
    primitive.place = place_of(*part.file, *id);
    primitive.name = function_name(primitive.code);
    if (!primitive.code.empty() && primitive.name.empty()) {
      reader.fail(*id, "the code has no function `float NAME(vec3 p, Primitive3D primitive)`");
    }
  }
  if (const auto id = object.member("name")) {
    const auto name = reader.text_that_is_not_empty(*id);
    if (name && !is_identifier(*name)) reader.fail(*id, fmt::format("`{}` is no name of a function", *name));
    if (name) primitive.name = *name;
  }
  if (const auto id = object.member("bounds")) {
    const auto half = reader.numbers(*id, 3, 3);
    if (half && std::ranges::any_of(*half, [](double size) { return size <= 0; }))
      reader.fail(*id, "half sizes are more than 0");
    if (half) primitive.bounds = scene::Triple{(*half)[0], (*half)[1], (*half)[2]};
  }
  if (const auto id = object.member("lipschitz")) primitive.lipschitz = reader.number(*id, 1e-3, 1e3).value_or(1);
  if (const auto code = object.member("code"); code && reader.error_count() == errors) {
    if (const auto fault = find_code_fault(primitive)) fail_code(reader, problems_, *code, primitive.place, *fault);
  }
  object.finish();
  if (is_full(reader, part.id, scene_.user_primitives, scene::kMaxUserPrimitives, "primitive")) return std::nullopt;
  if (reader.error_count() != errors) return std::nullopt;
  scene_.user_primitives.push_back(std::move(primitive));
  return scene::UserPrimitiveId{static_cast<uint32_t>(scene_.user_primitives.size() - 1)};
}

std::optional<scene::ShaderId> PartReader::read_shader(const Origin& part) {
  FileReader reader(*part.file, problems_);
  const uint32_t errors = reader.error_count();
  ObjectReader object(reader, part.id);
  object.member("$schema");
  scene::Shader shader;
  if (const auto id = object.required("name")) shader.name = reader.text_that_is_not_empty(*id).value_or("");
  if (const auto list = object.member("properties")) {
    const std::span<const JsonId> written = reader.list(*list);
    if (written.size() > kMaxProperties)
      reader.fail(*list, fmt::format("a shader has at most {} properties", kMaxProperties));
    for (const JsonId id : written.first(std::min(written.size(), kMaxProperties))) {
      const auto text = reader.text(id);
      if (!text) continue;
      const Result<scene::Property> property = read_property(*text);
      if (!property) {
        reader.fail(id, property.error());
      } else if (std::ranges::any_of(shader.properties,
                                     [&](const auto& other) { return other.name == property->name; })) {
        reader.fail(id, fmt::format("there are two properties `{}`", property->name));
      } else {
        shader.properties.push_back(*property);
      }
    }
  }
  if (const auto id = object.required("code")) {
    shader.code = read_code(reader, *id).value_or("");
    shader.place = place_of(*part.file, *id);
    const auto fault = shader.code.empty() ? std::nullopt : find_code_fault(shader);
    if (fault) fail_code(reader, problems_, *id, shader.place, *fault);
  }
  object.finish();
  if (is_full(reader, part.id, scene_.shaders, scene::kMaxShaders, "shader")) return std::nullopt;
  if (reader.error_count() != errors) return std::nullopt;
  scene_.shaders.push_back(std::move(shader));
  return scene::ShaderId{static_cast<uint32_t>(scene_.shaders.size() - 1)};
}

const Scope& PartReader::scope_of_file(const Origin& part) {
  const auto [entry, is_new] = scopes_.try_emplace(part.file);
  Scope& scope = entry->second;
  if (!is_new) return scope;
  scope.file = part.file;
  if (part.id.value == 0 || part.file->tree.root().kind != JsonKind::Object) return scope;
  Problems reported_by_others;
  FileReader reader(*part.file, reported_by_others);
  ObjectReader object(reader, JsonId{0});
  scope = read_scope(reader, object, table_);
  return scope;
}

std::optional<scene::ShaderId> PartReader::base_shader(FileReader& reader, const Origin& part, JsonId id,
                                                       const std::string& root) {
  const auto name = reader.text_that_is_not_empty(id);
  if (!name) return std::nullopt;
  const Origin where{part.file, id};
  if (is_document(*name)) return document(FileTable::resolve(*part.file, *name), root, where);
  const auto found = find_part(scope_of_file(part), PartKind::Shader, *name, where, table_, problems_);
  return found ? shader(*found) : std::nullopt;
}

std::optional<scene::MaterialId> PartReader::read_material(const Origin& part) {
  FileReader reader(*part.file, problems_);
  const uint32_t errors = reader.error_count();
  ObjectReader object(reader, part.id);
  object.member("$schema");
  scene::Material material;
  if (const auto id = object.member("name")) material.name = reader.text_that_is_not_empty(*id).value_or("");
  std::string root;
  if (const auto id = object.member("root")) root = reader.text_that_is_not_empty(*id).value_or("");
  std::optional<scene::ShaderId> shader;
  if (const auto id = object.required("base_shader")) shader = base_shader(reader, part, *id, root);
  const auto properties = object.member("properties");
  object.finish();
  if (!shader) return std::nullopt;
  material.shader = *shader;
  for (const scene::Property& property : scene_.shaders[shader->value].properties) {
    material.values.push_back(property.default_value);
  }
  if (properties) read_values(reader, *properties, material);
  if (is_full(reader, part.id, scene_.materials, scene::kMaxMaterials, "material")) return std::nullopt;
  if (reader.error_count() != errors) return std::nullopt;
  scene_.materials.push_back(std::move(material));
  return scene::MaterialId{static_cast<uint32_t>(scene_.materials.size() - 1)};
}

void PartReader::read_values(FileReader& reader, JsonId list, scene::Material& material) {
  const scene::Shader& shader = scene_.shaders[material.shader.value];
  const std::vector<std::string>& spellings = spellings_[material.shader.value];
  std::vector<bool> given(shader.properties.size());
  std::vector<std::string> names;
  for (const scene::Property& property : shader.properties) names.push_back(property.name);
  for (const JsonId id : reader.list(list)) {
    ObjectReader object(reader, id);
    const auto name_id = object.required("name");
    const auto type_id = object.member("type");
    const auto value_id = object.required("value");
    object.finish();
    const auto name = name_id ? reader.text(*name_id) : std::nullopt;
    if (!name) continue;
    auto found = static_cast<std::size_t>(std::ranges::find(names, *name) - names.begin());
    if (found == names.size() && !spellings.empty()) {
      const std::string canonical = canonical_name(*name).value_or(*name);
      found = static_cast<std::size_t>(std::ranges::find(spellings, canonical) - spellings.begin());
    }
    if (found >= names.size()) {
      reader.fail(*name_id,
                  fmt::format("the shader {} has no property `{}`{}", shader.name, *name, suggestion(*name, names)));
      continue;
    }
    const scene::Property& property = shader.properties[found];
    if (given[found]) reader.fail(*name_id, fmt::format("the property `{}` has two values", *name));
    given[found] = true;
    const auto type = type_id ? reader.text(*type_id) : std::nullopt;
    if (type && scene::find_property_type(*type) != property.type) {
      reader.fail(*type_id, fmt::format("the property `{}` is a {}, not a `{}`", *name,
                                        property_type_name(property.type), *type));
      continue;
    }
    const auto numbers = value_id ? numbers_of(reader, *value_id) : std::nullopt;
    if (!numbers) continue;
    const Result<scene::Triple> value = value_of(*numbers, property.type);
    if (!value) {
      reader.fail(*value_id, value.error());
      continue;
    }
    material.values[found] = *value;
    const auto is_outside = [&](double number) {
      return property.range && (number < property.range->least || number > property.range->greatest);
    };
    if (std::ranges::any_of(*numbers, is_outside)) {
      reader.warn(*value_id, fmt::format("the range of `{}` is {} to {}: what is outside is clamped", *name,
                                         property.range->least, property.range->greatest));
    }
  }
}

const ModelTree* PartReader::model(const Origin& part) {
  if (const auto known = models_.find(part); known != models_.end()) return known->second ? &*known->second : nullptr;
  std::optional<ModelTree> read = read_model(part);
  std::optional<ModelTree>& kept = models_[part];
  kept = std::move(read);
  return kept ? &*kept : nullptr;
}

std::optional<ModelTree> PartReader::read_model(const Origin& part) {
  FileReader reader(*part.file, problems_);
  if (std::ranges::find(inside_, part) != inside_.end()) {
    std::string chain;
    for (const Origin& model : inside_) chain += name_of_part(model, PartKind::Model) + " → ";
    reader.fail(part.id, fmt::format("the model contains itself: {}{}", chain, name_of_part(part, PartKind::Model)));
    return std::nullopt;
  }
  if (inside_.size() >= kMaxModelsInside) {
    reader.fail(part.id, fmt::format("models stand inside each other more than {} deep", kMaxModelsInside));
    return std::nullopt;
  }
  inside_.push_back(part);
  const uint32_t errors = reader.error_count();
  ObjectReader object(reader, part.id);
  object.member("$schema");
  if (const auto id = object.required("name")) (void)reader.text_that_is_not_empty(*id);
  const Scope declared = scope(reader, object);
  ModelTree model;
  std::optional<Placed> root;
  if (const auto id = object.required("model")) root = node(reader, declared, *id, model.tree, 1);
  object.finish();
  inside_.pop_back();
  if (!root || reader.error_count() != errors) return std::nullopt;
  model.root = *root;
  return model;
}

}  // namespace texbrdf::scene_json
