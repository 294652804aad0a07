#include "cli/check_scene.h"

#include <fmt/core.h>

#include "cli/messages.h"
#include "files/file_source.h"
#include "render/glsl_check.h"
#include "render/scene_text.h"
#include "render/shader_complaint.h"
#include "scene_json/code_mistake.h"
#include "scene_json/load_scene.h"

namespace texbrdf::cli {

bool is_scene_file(const std::string& path) {
  return path.ends_with(".json");
}

CheckedScene check_scene(const std::string& path) {
  files::DiskFiles disk;
  const std::string real = files::real_path(path);
  if (real.empty() || !disk.text(real)) {
    print_message(fmt::format("{}: cannot be read", path));
    return {{}, {}, ExitCode::BadUsage};
  }
  scene_json::LoadedScene loaded = scene_json::load_scene(real, disk);
  CheckedScene checked;
  const std::string here = files::real_path(".");
  for (const scene_json::Problem& problem : loaded.problems) checked.report += describe(problem, here) + "\n";
  checked.scene = std::move(loaded.scene);
  if (!checked.scene) checked.exit_code = ExitCode::DocumentHasErrors;
  return checked;
}

std::optional<std::string> mistake_in_code(const scene::SceneShader& shader, std::string_view complaint) {
  const auto found = render::find_complaint(complaint);
  if (!found) return std::nullopt;
  return scene_json::describe_code_mistake(shader, found->source, found->line, found->message, files::real_path("."));
}

CheckedScene check_scene_and_code(const std::string& path) {
  CheckedScene checked = check_scene(path);
  if (!checked.scene) return checked;
  const scene::SceneShader shader = make_scene_shader(*checked.scene);
  if (shader.places.empty()) return checked;
  const render::GlslChecker checker;
  const auto fault = checker.find_fault(render::scene_fragment_text(shader.source, {}));
  if (!fault) return checked;
  checked.report += mistake_in_code(shader, *fault).value_or(*fault) + "\n";
  checked.exit_code = ExitCode::DocumentHasErrors;
  return checked;
}

}  // namespace texbrdf::cli
