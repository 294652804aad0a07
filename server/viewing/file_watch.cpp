#include "viewing/file_watch.h"

#include <utility>

namespace texbrdf::viewing {

void FileWatch::watch(const std::vector<std::string>& paths) {
  std::map<std::string, files::FileStamp> stamps;
  for (const std::string& path : paths) {
    const auto before = stamps_.find(path);
    stamps[path] = before == stamps_.end() ? files::stamp_of(path) : before->second;
  }
  stamps_ = std::move(stamps);
}

bool FileWatch::has_changed() {
  bool changed = false;
  for (auto& [path, stamp] : stamps_) {
    const files::FileStamp now = files::stamp_of(path);
    changed = changed || !(now == stamp);
    stamp = now;
  }
  return changed;
}

}  // namespace texbrdf::viewing
