#include "lsp/session.h"

namespace texbrdf::lsp {

std::string Session::did_change_workspace_folders(const WorkspaceFoldersParams& params) {
  for (const std::string& uri : params.removed) folders_.remove(uri);
  for (const std::string& uri : params.added) folders_.add(uri);
  return {};
}

}  // namespace texbrdf::lsp
