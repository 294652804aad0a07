#pragma once

#include <span>
#include <string_view>

namespace texbrdf::pane {

struct EmbeddedFile {
  std::string_view name;
  std::string_view content;
};

/// What `npm run build:browser` made of vscode-extension; empty where that could not be run. CMake writes it.
std::span<const EmbeddedFile> embedded_files();

}  // namespace texbrdf::pane
