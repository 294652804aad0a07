#include "scene_json/code_mistake.h"

#include <fmt/format.h>

#include "scene_json/problem.h"

namespace texbrdf::scene_json {

std::optional<std::string> describe_code_mistake(const scene::SceneShader& shader, uint32_t source, uint32_t line,
                                                 std::string_view message, std::string_view folder) {
  if (source < 1 || source > shader.places.size()) return std::nullopt;
  const scene::CodePlace& place = shader.places[source - 1];
  const std::string_view file = path_from(place.file, folder);
  const std::string path = place.path.empty() ? "" : place.path + ": ";
  const std::string what = in_names_of_user(shader, source, message);
  if (place.first_line > 0) return fmt::format("{}({}) error: {}{}", file, line, path, what);
  return fmt::format("{} error: {}line {} of the code: {}", file, path, line, what);
}

}  // namespace texbrdf::scene_json
