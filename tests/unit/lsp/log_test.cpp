#include "lsp/log.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <sstream>
#include <string>

#include "lsp/log_output.h"
#include "lsp/uri.h"

namespace texbrdf::lsp {
namespace {

TEST(Log, ALevelShowsItselfAndThoseBefore) {
  std::string lines;
  Log log(LogLevel::Info, [&](std::string_view line) { lines += line.substr(line.find(']') + 2); });
  log.error("one");
  log.info("two");
  log.debug("three");
  EXPECT_EQ(lines, "error   one\ninfo    two\n");
}

TEST(Log, AnEventIsOneLine) {
  std::string lines;
  Log log(LogLevel::Trace, [&](std::string_view line) { lines += line.substr(line.find(']') + 2); });
  log.trace("a\r\nb\x1b ℝ");
  EXPECT_EQ(lines, "trace   a\\x0d\\x0ab\\x1b ℝ\n");
}

TEST(Log, LevelsHaveNames) {
  for (const auto level : {LogLevel::Error, LogLevel::Warning, LogLevel::Info, LogLevel::Debug, LogLevel::Trace}) {
    EXPECT_EQ(log_level(log_level_name(level)), level);
  }
  EXPECT_FALSE(log_level("verbose"));
}

TEST(LogOutput, AFileIsAppendedTo) {
  const std::string path = testing::TempDir() + "texbrdf-log-test-" + std::to_string(getpid());
  for (const char* line : {"first\n", "second\n"}) {
    auto output = LogOutput::to_file(path);
    ASSERT_TRUE(output);
    output->write(line);
  }
  std::stringstream content;
  content << std::ifstream(path).rdbuf();
  unlink(path.c_str());
  EXPECT_EQ(content.str(), "first\nsecond\n");
  EXPECT_FALSE(LogOutput::to_file("/nowhere/at/all"));
}

TEST(Uri, AFileIsShownByItsPath) {
  EXPECT_EQ(shown_path("file:///a/b%20c.tex"), "/a/b c.tex");
  EXPECT_EQ(shown_path("file:///a/%ce%b8%2"), "/a/θ%2");
  EXPECT_EQ(shown_path("file:///100%zz"), "/100%zz");
  EXPECT_EQ(shown_path("untitled:a%20b"), "untitled:a%20b");
}

}  // namespace
}  // namespace texbrdf::lsp
