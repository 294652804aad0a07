#include "pane/pages.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace texbrdf::pane {
namespace {

const web::Page* find_page(const std::vector<web::Page>& pages, std::string_view path) {
  const auto found = std::ranges::find(pages, path, &web::Page::path);
  return found == pages.end() ? nullptr : &*found;
}

bool has(const web::Page& page, std::string_view text) {
  return page.body.find(text) != std::string::npos;
}

TEST(Pages, TheFirstIsThePaneOrSaysWhyItIsMissing) {
  const std::vector<web::Page> all = pages();
  const web::Page* const first = find_page(all, "");
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->content_type, "text/html; charset=utf-8");
  EXPECT_EQ(has(*first, "id=\"stage\""), is_built());
  EXPECT_EQ(has(*first, "was built without Node"), !is_built());
}

TEST(Pages, WhatThePaneLoadsIsThere) {
  if (!is_built()) GTEST_SKIP() << "built without Node";
  const std::vector<web::Page> all = pages();
  for (const auto& [path, type] : {std::pair("preview.js", "text/javascript; charset=utf-8"),
                                   std::pair("preview.css", "text/css; charset=utf-8")}) {
    const web::Page* const page = find_page(all, path);
    ASSERT_NE(page, nullptr) << path;
    EXPECT_EQ(page->content_type, type);
    EXPECT_TRUE(has(*find_page(all, ""), "\"" + std::string(path) + "\"")) << path;
  }
  EXPECT_TRUE(has(*find_page(all, "preview.css"), "prefers-color-scheme: dark"));
  EXPECT_TRUE(has(*find_page(all, "preview.js"), "texbrdf/openPreview"));
}

}  // namespace
}  // namespace texbrdf::pane
