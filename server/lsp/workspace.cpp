#include "lsp/configuration.h"
#include "lsp/session.h"
#include "lsp/uri.h"

namespace texbrdf::lsp {

std::string Session::did_change_workspace_folders(const WorkspaceFoldersParams& params) {
  for (const std::string& uri : params.removed) folders_.remove(uri);
  for (const std::string& uri : params.added) folders_.add(uri);
  documents_.projects().set_folders(folder_paths());
  return {};
}

std::vector<std::string> Session::folder_paths() const {
  std::vector<std::string> paths;
  for (const std::string& uri : folders_.uris()) paths.push_back(shown_path(uri));
  return paths;
}

/// Files that are not open are read from the disk.
void Session::watch_files() {
  if (!client_.file_watchers) return;
  outbox_.request("client/registerCapability", [](JsonWriter& out) {
    write_registration(out, "workspace/didChangeWatchedFiles", [](JsonWriter& options) {
      options.key("watchers");
      options.begin_array();
      options.begin_object();
      options.member("globPattern", "**/*.tex");
      options.end_object();
      options.begin_object();
      options.member("globPattern", "**/*.{scene,model,material,shader,primitive}.json");
      options.end_object();
      options.end_array();
    });
  });
}

std::string Session::did_change_watched_files(const NoParams&) {
  documents_.projects().disk_changed();
  scenes_.disk_changed();
  return {};
}

}  // namespace texbrdf::lsp
