#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texbrdf::lsp {

/// The folders that the client has open. Only files below them may be read.
class WorkspaceFolders {
 public:
  void add(std::string uri);
  void remove(std::string_view uri);

  /// As the client writes them, in the order in which they came.
  std::span<const std::string> uris() const { return uris_; }
  /// True where an absolute path lies in a folder or is one, by its text alone: links are for who reads to follow.
  bool contains(std::string_view path) const;

 private:
  std::vector<std::string> uris_;
};

}  // namespace texbrdf::lsp
