#include "render/child_process.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iterator>
#include <string>
#include <thread>

namespace texbrdf::render {
namespace {

using namespace std::chrono_literals;

Result<ChildProcess> shell(const std::string& script, const std::vector<std::string>& environment = {}) {
  return ChildProcess::start("/bin/sh", {"-c", script}, environment);
}

std::string read_all(const ChildProcess& child) {
  std::string text;
  std::array<char, 256> buffer;
  pollfd entry{child.socket(), POLLIN, 0};
  while (poll(&entry, 1, 10'000) > 0) {
    const ssize_t count = read(child.socket(), buffer.data(), buffer.size());
    if (count <= 0) break;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return text;
}

std::ptrdiff_t open_files() {
  return std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {});
}

TEST(ChildProcess, TalksOverItsStandardStreams) {
  auto child = shell("read line; echo \"got $line\"");
  ASSERT_TRUE(child);
  ASSERT_EQ(write(child->socket(), "word\n", 5), 5);
  EXPECT_EQ(read_all(*child), "got word\n");
}

TEST(ChildProcess, GetsTheEnvironmentItIsGiven) {
  ASSERT_EQ(setenv("TEXBRDF_TEST_KEPT", "kept", 1), 0);
  ASSERT_EQ(setenv("TEXBRDF_TEST_CHANGED", "old", 1), 0);
  auto child = shell("echo $TEXBRDF_TEST_KEPT $TEXBRDF_TEST_CHANGED", {"TEXBRDF_TEST_CHANGED=new"});
  ASSERT_TRUE(child);
  EXPECT_EQ(read_all(*child), "kept new\n");
}

TEST(ChildProcess, SaysHowItEnded) {
  auto coded = shell("exit 3");
  ASSERT_TRUE(coded);
  read_all(*coded);
  EXPECT_EQ(coded->finish(), "ended with code 3");
  auto killed = shell("kill -SEGV $$");
  ASSERT_TRUE(killed);
  read_all(*killed);
  EXPECT_EQ(killed->finish(), "was killed by signal 11 (Segmentation fault)");
}

TEST(ChildProcess, IsKilledWhereItStillRuns) {
  auto child = shell("trap '' TERM; while :; do :; done");
  ASSERT_TRUE(child);
  EXPECT_FALSE(child->has_ended());
  EXPECT_EQ(child->finish(), "was killed by signal 9 (Killed)");
}

TEST(ChildProcess, LeavesNeitherProcessNorFileBehind) {
  const auto before = open_files();
  pid_t process = -1;
  {
    auto child = shell("exec sleep 60");
    ASSERT_TRUE(child);
    process = child->process_id();
    ChildProcess moved = *std::move(child);
    EXPECT_EQ(moved.process_id(), process);
  }
  EXPECT_EQ(open_files(), before);
  EXPECT_EQ(kill(process, 0), -1);
}

TEST(ChildProcess, AMissingProgramIsTold) {
  const auto before = open_files();
  const auto child = ChildProcess::start("/nonexistent/program", {}, {});
  ASSERT_FALSE(child);
  EXPECT_NE(child.error().find("/nonexistent/program"), std::string::npos);
  EXPECT_EQ(open_files(), before);
}

}  // namespace
}  // namespace texbrdf::render
