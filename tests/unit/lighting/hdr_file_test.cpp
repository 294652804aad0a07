#include "lighting/hdr_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "support/read_file.h"

// tests/data/lights/write_lights.py wrote the files and says what they hold.

namespace texbrdf::lighting {
namespace {

std::string bytes_of(const std::string& name) {
  return test::read_file(std::string(TEXBRDF_TEST_DATA) + "/lights/" + name + ".hdr");
}

class HdrFile : public testing::TestWithParam<std::string> {};

TEST_P(HdrFile, HoldsThePicture) {
  const Result<EnvironmentMap> map = read_hdr(bytes_of(GetParam()));
  ASSERT_TRUE(map) << map.error();
  ASSERT_EQ(map->width, 16);
  ASSERT_EQ(map->height, 8);
  ASSERT_EQ(map->radiance.size(), 128);
  for (uint32_t i = 0; i < 128; ++i) {
    const auto row = static_cast<float>(i / 16);
    const float factor = row >= 4 ? 4 : 1;
    EXPECT_EQ(map->radiance[i], factor * glm::vec3(static_cast<float>(i % 16 + 1), row / 8, 0.25F)) << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Good, HdrFile,
                         testing::Values("plain", "new-runs", "from-bottom", "from-right", "exposed", "corrected"),
                         [](const auto& file) {
                           std::string name = file.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(HdrFile, ReadsOldRunsOfMoreThanAByteCounts) {
  const Result<EnvironmentMap> map = read_hdr(bytes_of("old-runs"));
  ASSERT_TRUE(map) << map.error();
  ASSERT_EQ(map->radiance.size(), 600 * 300);
  for (uint32_t row : {0U, 1U, 150U, 299U}) {
    for (uint32_t column : {0U, 299U, 599U}) {
      EXPECT_NEAR(map->radiance[row * 600 + column].x, static_cast<float>(row + 1), (row + 1) / 128.0) << row;
    }
  }
}

TEST(HdrFile, ReadsOldRunsOfNarrowPictures) {
  const Result<EnvironmentMap> map = read_hdr(bytes_of("old-runs-short"));
  ASSERT_TRUE(map) << map.error();
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(map->radiance[i], glm::vec3(i % 4 == 3 ? 8 : 1)) << i;
}

TEST(HdrFile, TellsWhatIsWrong) {
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(TEXBRDF_TEST_DATA "/lights/broken")) {
    const std::string bytes = test::read_file(entry.path());
    constexpr std::string_view kMark = "# expect: ";
    const std::size_t begin = bytes.find(kMark);
    ASSERT_NE(begin, std::string::npos) << entry.path();
    const std::string expected = bytes.substr(begin + kMark.size(), bytes.find('\n', begin) - begin - kMark.size());
    const Result<EnvironmentMap> map = read_hdr(bytes);
    ASSERT_FALSE(map) << entry.path();
    EXPECT_TRUE(map.error().find(expected) != std::string::npos) << entry.path() << ": " << map.error();
    ++files;
  }
  EXPECT_GE(files, 24);
}

TEST(HdrFile, OtherFilesAreNone) {
  for (const std::string_view bytes : {"", "#", "PNG", "P6 1 1 255"}) {
    const Result<EnvironmentMap> map = read_hdr(bytes);
    ASSERT_FALSE(map);
    EXPECT_TRUE(map.error().find("no Radiance picture") != std::string::npos);
  }
}

/// Any end of a good file, also within a run, is noticed.
TEST(HdrFile, AFileThatWasCutOffIsNoPicture) {
  for (const char* name : {"plain", "new-runs", "old-runs-short"}) {
    const std::string bytes = bytes_of(name);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      EXPECT_FALSE(read_hdr(std::string_view(bytes).substr(0, size))) << name << ' ' << size;
    }
  }
}

}  // namespace
}  // namespace texbrdf::lighting
