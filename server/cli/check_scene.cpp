#include "cli/check_scene.h"

#include <fmt/core.h>

#include "cli/messages.h"
#include "files/file_source.h"
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

}  // namespace texbrdf::cli
