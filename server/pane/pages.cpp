#include "pane/pages.h"

#include <array>
#include <string_view>

#include "pane/embedded_files.h"

namespace texbrdf::pane {
namespace {

constexpr std::string_view kFirstPage = "index.html";
constexpr std::string_view kSubstitute =
    "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>texbrdf preview</title></head>\n"
    "<body><h1>There is no preview here</h1>\n<p>This <code>texbrdf</code> was built without Node, which bundles the "
    "preview's page. <code>./dev build</code> installs it and builds the program with the page; <code>./dev "
    "package</code> always does. Everything else of the language server works.</p></body></html>\n";

struct ContentType {
  std::string_view ending;
  std::string_view type;
};

constexpr auto kContentTypes = std::to_array<ContentType>({
    {".html", "text/html; charset=utf-8"},
    {".js", "text/javascript; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".svg", "image/svg+xml"},
});

std::string_view content_type_of(std::string_view name) {
  for (const auto& [ending, type] : kContentTypes) {
    if (name.ends_with(ending)) return type;
  }
  return "application/octet-stream";
}

}  // namespace

bool is_built() {
  return !embedded_files().empty();
}

std::vector<web::Page> pages() {
  if (!is_built()) return {{"", std::string(content_type_of(kFirstPage)), std::string(kSubstitute)}};
  std::vector<web::Page> pages;
  for (const auto& [name, content] : embedded_files()) {
    const std::string_view path = name == kFirstPage ? std::string_view() : name;
    pages.push_back({std::string(path), std::string(content_type_of(name)), std::string(content)});
  }
  return pages;
}

}  // namespace texbrdf::pane
