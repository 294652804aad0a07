#include "lsp/workspace_folders.h"

#include <algorithm>
#include <utility>

#include "lsp/uri.h"

namespace texbrdf::lsp {
namespace {

/// Without `.`, `..`, empty names and a slash at the end; `..` of the root is the root. Empty for a relative path.
std::string normal_path(std::string_view path) {
  if (!path.starts_with('/')) return {};
  std::string normal;
  while (!path.empty()) {
    path.remove_prefix(1);
    const std::size_t end = std::min(path.find('/'), path.size());
    const std::string_view name = path.substr(0, end);
    path.remove_prefix(end);
    if (name == "..") {
      normal.resize(std::min(normal.rfind('/'), normal.size()));
    } else if (!name.empty() && name != ".") {
      normal += '/';
      normal += name;
    }
  }
  return normal.empty() ? "/" : normal;
}

bool is_below(std::string_view path, std::string_view folder) {
  if (folder.empty()) return false;
  if (folder == "/" || path == folder) return true;
  return path.starts_with(folder) && path[folder.size()] == '/';
}

}  // namespace

void WorkspaceFolders::add(std::string uri) {
  if (std::ranges::find(uris_, uri) == uris_.end()) uris_.push_back(std::move(uri));
}

void WorkspaceFolders::remove(std::string_view uri) {
  std::erase(uris_, uri);
}

bool WorkspaceFolders::contains(std::string_view path) const {
  const std::string normal = normal_path(path);
  if (normal.empty()) return false;
  return std::ranges::any_of(uris_,
                             [&](const std::string& uri) { return is_below(normal, normal_path(shown_path(uri))); });
}

}  // namespace texbrdf::lsp
