#pragma once

#include <map>
#include <string>
#include <vector>

#include "files/file_source.h"

namespace texbrdf::viewing {

/// Notices changes of files on the disk, missing ones that come to be included.
class FileWatch {
 public:
  /// What is watched from now on. A file that was watched before keeps the state that `has_changed` saw last: a change
  /// since then is noticed.
  void watch(const std::vector<std::string>& paths);
  /// Since it was asked last. Looks at each file.
  bool has_changed();

 private:
  std::map<std::string, files::FileStamp> stamps_;
};

}  // namespace texbrdf::viewing
