#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/file_source.h"
#include "scene_json/load_scene.h"
#include "viewing/file_watch.h"

namespace texbrdf::viewing {

/// The files of a scene, read again whenever they change.
class LiveScene {
 public:
  /// `files` reads what is watched on the disk, and outlives the object.
  LiveScene(std::string path, files::FileSource& files) : path_(std::move(path)), files_(files) {}

  /// What the files say, where they have changed since they were read last, or were never read.
  std::optional<scene_json::LoadedScene> read_changed();

 private:
  std::string path_;
  files::FileSource& files_;
  FileWatch watch_;
  bool was_read_ = false;
};

}  // namespace texbrdf::viewing
