#include "lsp/workspace_folders.h"

#include <gtest/gtest.h>

namespace texbrdf::lsp {
namespace {

TEST(WorkspaceFolders, ContainWhatLiesBelowThem) {
  WorkspaceFolders folders;
  EXPECT_FALSE(folders.contains("/a/b.tex"));
  folders.add("file:///a/my%20papers/");
  EXPECT_TRUE(folders.contains("/a/my papers/b.tex"));
  EXPECT_TRUE(folders.contains("/a/my papers"));
  EXPECT_TRUE(folders.contains("/a/./x/..//my papers/deep/er/b.tex"));
  EXPECT_FALSE(folders.contains("/a/my papers 2/b.tex"));
  EXPECT_FALSE(folders.contains("/a"));
  EXPECT_FALSE(folders.contains("/a/my papers/../secret.tex"));
  EXPECT_FALSE(folders.contains("/a/my papers/../../../../etc/passwd"));
  EXPECT_FALSE(folders.contains("a/my papers/b.tex"));
  EXPECT_FALSE(folders.contains(""));
}

TEST(WorkspaceFolders, ComeAndGo) {
  WorkspaceFolders folders;
  folders.add("file:///a");
  folders.add("file:///b");
  folders.add("file:///a");
  ASSERT_EQ(folders.uris().size(), 2u);
  EXPECT_TRUE(folders.contains("/b/x.tex"));
  folders.remove("file:///b");
  folders.remove("file:///nowhere");
  EXPECT_FALSE(folders.contains("/b/x.tex"));
  EXPECT_TRUE(folders.contains("/a/x.tex"));
}

TEST(WorkspaceFolders, TheRootContainsAllAndOtherSchemesNothing) {
  WorkspaceFolders folders;
  folders.add("untitled:a");
  folders.add("https://example.org/a");
  folders.add("");
  EXPECT_FALSE(folders.contains("/a"));
  folders.add("file:///");
  EXPECT_TRUE(folders.contains("/a"));
  EXPECT_TRUE(folders.contains("/../.."));
}

}  // namespace
}  // namespace texbrdf::lsp
