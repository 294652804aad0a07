#include "viewing/file_watch.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace texbrdf::viewing {
namespace {

namespace fs = std::filesystem;

class FileWatchTest : public testing::Test {
 protected:
  FileWatchTest() { fs::create_directories(folder_); }
  ~FileWatchTest() override { fs::remove_all(folder_); }

  std::string path(const char* name) const { return (folder_ / name).string(); }
  void write(const char* name, const char* text) const { std::ofstream(path(name)) << text; }

 private:
  fs::path folder_ = fs::path(testing::TempDir()) /
                     (std::string("file_watch_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(FileWatchTest, SeesAChangeOnce) {
  write("a", "one");
  FileWatch watch;
  watch.watch({path("a")});
  EXPECT_FALSE(watch.has_changed());
  write("a", "three");
  EXPECT_TRUE(watch.has_changed());
  EXPECT_FALSE(watch.has_changed());
}

TEST_F(FileWatchTest, SeesAnotherTimeOfTheSameSize) {
  write("a", "one");
  FileWatch watch;
  watch.watch({path("a")});
  write("a", "two");
  fs::last_write_time(path("a"), fs::last_write_time(path("a")) + std::chrono::seconds(1));
  EXPECT_TRUE(watch.has_changed());
}

TEST_F(FileWatchTest, SeesFilesComeAndGo) {
  FileWatch watch;
  watch.watch({path("a")});
  EXPECT_FALSE(watch.has_changed());
  write("a", "one");
  EXPECT_TRUE(watch.has_changed());
  fs::remove(path("a"));
  EXPECT_TRUE(watch.has_changed());
}

TEST_F(FileWatchTest, AChangeBeforeFilesAreNamedAgainIsSeen) {
  write("a", "one");
  write("b", "one");
  FileWatch watch;
  watch.watch({path("a")});
  write("a", "three");
  watch.watch({path("a"), path("b")});
  EXPECT_TRUE(watch.has_changed());
  watch.watch({path("b")});
  write("a", "eleven");
  EXPECT_FALSE(watch.has_changed());
}

}  // namespace
}  // namespace texbrdf::viewing
