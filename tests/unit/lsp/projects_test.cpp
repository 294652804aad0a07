#include "lsp/projects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

namespace texbrdf::lsp {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMain = "\\input{part}\\begin{equation}f = m * \\theta_h\\end{equation}";

/// A workspace folder of its own.
class ProjectsTest : public testing::Test {
 protected:
  ProjectsTest() {
    std::string name = (fs::temp_directory_path() / "texbrdf-XXXXXX").string();
    EXPECT_NE(mkdtemp(name.data()), nullptr);
    folder_ = fs::canonical(name);
    projects_.set_folders(std::vector{folder_.string()});
  }
  ~ProjectsTest() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, std::string_view text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }
  Buffer& open(const std::string& name, std::string_view text) { return projects_.open(path(name), SourceText(text)); }
  bool is_right(Buffer& buffer) { return !projects_.snapshot(buffer).has_errors(); }

  fs::path folder_;
  Projects projects_;
};

std::string definition(const std::string& equation) {
  return "\\begin{equation}" + equation + "\\end{equation}";
}

TEST_F(ProjectsTest, AFileThatChangesUntoldIsReadAgainAtTheNextQuestion) {
  write("part.tex", definition("m = "));
  Buffer& main = open("main.tex", kMain);
  EXPECT_FALSE(is_right(main));
  write("part.tex", definition("m = 2"));
  std::this_thread::sleep_for(std::chrono::milliseconds(250));
  EXPECT_TRUE(is_right(main));
  fs::remove(path("part.tex"));
  std::this_thread::sleep_for(std::chrono::milliseconds(250));
  EXPECT_FALSE(is_right(main));
}

TEST_F(ProjectsTest, WhatIsOpenCountsAndNotTheDisk) {
  write("part.tex", definition("m = "));
  Buffer& main = open("main.tex", kMain);
  Buffer& part = open("part.tex", definition("m = 2"));
  EXPECT_TRUE(is_right(main));
  EXPECT_EQ(part.home, main.home);
  projects_.close(part);
  EXPECT_FALSE(is_right(main));
}

TEST_F(ProjectsTest, AFileMovesWithTheCommandThatIncludesIt) {
  Buffer& part = open("part.tex", definition("m = 2"));
  Buffer& main = open("main.tex", definition("f = m"));
  EXPECT_FALSE(is_right(main));
  EXPECT_NE(part.home, main.home);
  projects_.replace(main, {}, "\\input{part}");
  EXPECT_TRUE(is_right(main));
  EXPECT_EQ(part.home, main.home);
  projects_.replace(main, {0, 1}, "");
  EXPECT_FALSE(is_right(main));
  EXPECT_NE(part.home, main.home);
  EXPECT_EQ(projects_.snapshot(part).text().bytes(), definition("m = 2"));
}

TEST_F(ProjectsTest, FilesThatIncludeEachOtherAreInOneProject) {
  Buffer& a = open("a.tex", "\\input{b}");
  Buffer& b = open("b.tex", "\\input{a}");
  projects_.snapshot(a);
  EXPECT_EQ(a.home, b.home);
  EXPECT_EQ(a.file, FileId{0});
}

TEST_F(ProjectsTest, AFileOfTwoProjectsIsTheSameInBoth) {
  Buffer& first = open("first.tex", "\\input{part}" + definition("f = m * \\theta_h"));
  Buffer& second = open("second.tex", "\\input{part}" + definition("f = m + 1"));
  Buffer& part = open("part.tex", definition("m = "));
  EXPECT_FALSE(is_right(first));
  EXPECT_FALSE(is_right(second));
  projects_.replace(part, {20, 20}, "2");
  EXPECT_TRUE(is_right(first));
  EXPECT_TRUE(is_right(second));
}

TEST_F(ProjectsTest, WhatAFaultLeftBehindIsFormedAnewFromTheTexts) {
  write("part.tex", definition("m = 2"));
  Buffer& main = open("main.tex", kMain);
  Buffer& late = open("late.tex", definition("x = "));
  EXPECT_TRUE(is_right(main));
  projects_.replace(main, {0, 0}, "\\input{late}" + definition("(q = "));
  projects_.replace(late, {20, 20}, "1");
  main.home->document.set_text(FileId{1}, definition("m = "));
  projects_.start_anew();
  EXPECT_FALSE(is_right(main));
  EXPECT_EQ(main.home->paths, (std::vector{path("main.tex"), path("late.tex"), path("part.tex")}));
  EXPECT_EQ(late.home, main.home);
  EXPECT_EQ(projects_.snapshot(late).text().bytes(), definition("x = 1"));
  projects_.replace(main, {11, 11 + 35}, "");
  EXPECT_TRUE(is_right(main)) << main.text.bytes();
}

TEST_F(ProjectsTest, NothingOutsideTheFoldersIsRead) {
  projects_.set_folders({});
  write("part.tex", definition("m = 2"));
  Buffer& main = open("main.tex", kMain);
  EXPECT_FALSE(is_right(main));
  EXPECT_EQ(main.home->paths.size(), 1u);
}

TEST_F(ProjectsTest, ALinkThatLeadsOutIsNotFollowed) {
  fs::create_directory(folder_ / "inside");
  write("part.tex", definition("m = 2"));
  fs::create_symlink(folder_ / "part.tex", folder_ / "inside" / "part.tex");
  projects_.set_folders(std::vector{path("inside")});
  Buffer& main = open("inside/main.tex", kMain);
  const std::vector<Diagnostic> all = projects_.snapshot(main).diagnostics();
  EXPECT_EQ(std::ranges::count(all, Code::OutsideWorkspace, &Diagnostic::code), 1);
  EXPECT_EQ(std::ranges::count(all, Code::UndefinedName, &Diagnostic::code), 1);
}

}  // namespace
}  // namespace texbrdf::lsp
