#include "transcript.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace texbrdf::test {
namespace {

namespace fs = std::filesystem;

std::string file_text(const fs::path& path) {
  std::stringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

std::vector<std::string> transcripts() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(TEXBRDF_TRANSCRIPTS)) {
    if (entry.path().extension() == ".lsp") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class Transcript : public testing::TestWithParam<std::string> {};

TEST_P(Transcript, Holds) {
  const fs::path path = fs::path(TEXBRDF_TRANSCRIPTS) / (GetParam() + ".lsp");
  const std::string expected = file_text(path);
  const std::string played = play(expected);
  if (std::getenv("GOLDEN_UPDATE") != nullptr) {
    std::ofstream(path, std::ios::binary) << played;
  } else {
    EXPECT_EQ(played, expected);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Transcript, testing::ValuesIn(transcripts()), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(TranscriptFolder, HoldsTranscripts) {
  EXPECT_GE(transcripts().size(), 10u);
}

}  // namespace
}  // namespace texbrdf::test
