#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene_json/file_table.h"

namespace texbrdf::scene_json {

/// What has a file of its own, and a list in the files that use it.
enum class PartKind : uint8_t { Primitive, Shader, Material, Model };
inline constexpr std::size_t kPartKinds = 4;

struct PartName {
  std::string_view list;       ///< "models"
  std::string_view extension;  ///< ".model.json"
  std::string_view noun;       ///< "model"
};
const PartName& part_name(PartKind kind);

/// The parts that the lists of a scene or of a model declare, in their order.
struct Scope {
  const JsonFile* file = nullptr;
  struct Part {
    std::string name;
    Origin where;
  };
  std::array<std::vector<std::optional<Part>>, kPartKinds> parts;  ///< nothing for one that cannot be read
};

/// Reads the four lists.
Scope read_scope(FileReader& reader, ObjectReader& object, FileTable& table);

/// A declared part, or one in a file `NAME.kind.json` beside the file, or in the file that `name` is the path of. What
/// is not found is reported at `where`.
std::optional<Origin> find_part(const Scope& scope, PartKind kind, std::string_view name, const Origin& where,
                                FileTable& table, Problems& problems);

/// `name` of the part; of a primitive without one: the name of its function.
std::string name_of_part(const Origin& part, PartKind kind);

/// The text of `code`: a string, or a list of lines.
std::optional<std::string> read_code(FileReader& reader, JsonId id);
/// The name of the first function `float NAME(vec3 …` in the code; empty where there is none.
std::string function_name(std::string_view code);

}  // namespace texbrdf::scene_json
