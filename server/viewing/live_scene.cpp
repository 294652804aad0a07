#include "viewing/live_scene.h"

namespace texbrdf::viewing {

std::optional<scene_json::LoadedScene> LiveScene::read_changed() {
  if (was_read_ && !watch_.has_changed()) return std::nullopt;
  // Before it is read: what changes meanwhile is read once more.
  if (!was_read_) watch_.watch({path_});
  was_read_ = true;
  scene_json::LoadedScene loaded = scene_json::load_scene(path_, files_);
  watch_.watch(loaded.files);
  return loaded;
}

}  // namespace texbrdf::viewing
