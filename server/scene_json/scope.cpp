#include "scene_json/scope.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene_json/property_text.h"
#include "source/trimmed.h"

namespace texbrdf::scene_json {
namespace {

constexpr std::array<PartName, kPartKinds> kPartNames = {{
    {"primitives", ".primitive.json", "primitive"},
    {"shaders", ".shader.json", "shader"},
    {"materials", ".material.json", "material"},
    {"models", ".model.json", "model"},
}};

constexpr std::size_t kMaxListed = 1024;

const JsonValue* member_of(const Origin& part, std::string_view key) {
  const JsonTree& tree = part.file->tree;
  if (tree[part.id].kind != JsonKind::Object) return nullptr;
  for (const JsonId id : tree[part.id].elements) {
    if (tree[id].key == key) return &tree[id];
  }
  return nullptr;
}

/// A path is told from a name by its end.
bool is_path(std::string_view text) {
  return text.ends_with(".json");
}

std::optional<Origin> open_part(FileTable& table, const std::string& path, const Origin& where) {
  const JsonFile* file = table.open(path, &where);
  if (file == nullptr) return std::nullopt;
  return Origin{file, JsonId{0}};
}

std::optional<Scope::Part> read_declaration(FileReader& reader, JsonId id, PartKind kind, FileTable& table) {
  const Origin here{&reader.file(), id};
  std::optional<Origin> part;
  if (reader[id].kind == JsonKind::String) {
    const std::string& text = reader[id].text;
    const std::string path = is_path(text) ? text : text + std::string(part_name(kind).extension);
    part = open_part(table, FileTable::resolve(reader.file(), path), here);
  } else if (reader[id].kind == JsonKind::Object) {
    part = here;
  } else {
    reader.fail(id, fmt::format("this has to be the path of a {} or the {} itself", part_name(kind).noun,
                                part_name(kind).noun));
  }
  if (!part) return std::nullopt;
  return Scope::Part{name_of_part(*part, kind), *part};
}

}  // namespace

const PartName& part_name(PartKind kind) {
  return kPartNames[static_cast<std::size_t>(kind)];
}

std::string function_name(std::string_view code) {
  constexpr std::string_view kType = "float";
  for (std::size_t at = code.find(kType); at != std::string_view::npos; at = code.find(kType, at + 1)) {
    if (at > 0 && is_identifier(code.substr(at - 1, 1))) continue;
    const std::string_view rest = code.substr(at + kType.size());
    const std::size_t open = rest.find('(');
    if (open == std::string_view::npos) return {};
    const std::string_view name = trimmed(rest.substr(0, open));
    const std::string_view arguments = trimmed(rest.substr(open + 1));
    const bool takes_point = arguments.starts_with("vec3") || arguments.starts_with("float3");
    if (takes_point && is_identifier(name) && rest.find_first_not_of(" \t\r\n") > 0) return std::string(name);
  }
  return {};
}

std::optional<std::string> read_code(FileReader& reader, JsonId id) {
  if (reader[id].kind != JsonKind::Array) return reader.text_that_is_not_empty(id);
  std::string code;
  for (const JsonId line : reader[id].elements) {
    const std::optional<std::string> text = reader.text(line);
    if (!text) return std::nullopt;
    code += *text + "\n";
  }
  return code;
}

std::string name_of_part(const Origin& part, PartKind kind) {
  const JsonValue* name = member_of(part, "name");
  if (name != nullptr) return name->kind == JsonKind::String ? name->text : std::string();
  const JsonValue* code = kind == PartKind::Primitive ? member_of(part, "code") : nullptr;
  if (code == nullptr) return {};
  if (code->kind == JsonKind::String) return function_name(code->text);
  std::string lines;
  for (const JsonId line : code->elements) lines += part.file->tree[line].text + "\n";
  return function_name(lines);
}

Scope read_scope(FileReader& reader, ObjectReader& object, FileTable& table) {
  Scope scope;
  scope.file = &reader.file();
  for (std::size_t k = 0; k < kPartKinds; ++k) {
    const auto kind = static_cast<PartKind>(k);
    const std::optional<JsonId> list = object.member(part_name(kind).list);
    if (!list) continue;
    if (reader.list(*list).size() > kMaxListed) {
      reader.fail(*list, fmt::format("a list of {}s has at most {}", part_name(kind).noun, kMaxListed));
      continue;
    }
    for (const JsonId id : reader[*list].elements) {
      const std::optional<Scope::Part> part = read_declaration(reader, id, kind, table);
      const bool is_twice = part && !part->name.empty() && std::ranges::any_of(scope.parts[k], [&](const auto& other) {
                              return other && other->name == part->name;
                            });
      if (is_twice)
        reader.fail(id, fmt::format("there are two {}s of the name `{}` here", part_name(kind).noun, part->name));
      scope.parts[k].push_back(part);
    }
  }
  return scope;
}

std::optional<Origin> find_part(const Scope& scope, PartKind kind, std::string_view name, const Origin& where,
                                FileTable& table, Problems& problems) {
  const auto& declared = scope.parts[static_cast<std::size_t>(kind)];
  for (const auto& part : declared) {
    if (part && part->name == name) return part->where;
  }
  if (is_path(name)) return open_part(table, FileTable::resolve(*scope.file, name), where);
  const PartName& known = part_name(kind);
  const std::string file = std::string(name) + std::string(known.extension);
  const std::string path = FileTable::resolve(*scope.file, file);
  if (table.may_read(path) && table.exists(path)) return open_part(table, path, where);
  std::vector<std::string> names;
  for (const auto& part : declared) {
    if (part && !problems.is_full()) names.push_back(part->name);
  }
  problems.add(*where.file, where.id,
               fmt::format("there is no {} `{}`: `{}` here does not have it, and there is no file {}{}", known.noun,
                           name, known.list, file, suggestion(name, names)));
  return std::nullopt;
}

}  // namespace texbrdf::scene_json
