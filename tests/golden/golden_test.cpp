// One test for each document and stage: the stage's output is what the golden file beside the document holds.
// `documents/NAME.tex` begins with `% golden: STAGE …`, its golden files stand beside it; those of the models stand in
// `models/`. With GOLDEN_UPDATE set in the environment the files are rewritten instead.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "analysis/document.h"
#include "stages.h"

namespace texbrdf::test {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class GoldenTest : public testing::Test {
 public:
  GoldenTest(fs::path document, fs::path golden, const Stage& stage)
      : document_(std::move(document)), golden_(std::move(golden)), stage_(stage) {}

  void TestBody() override {
    Document document(read(document_));
    std::string output = stage_.output(document.snapshot());
    if (std::getenv("GOLDEN_UPDATE") != nullptr) {
      std::ofstream(golden_, std::ios::binary) << output;
      return;
    }
    ASSERT_TRUE(fs::exists(golden_)) << golden_ << " is missing: GOLDEN_UPDATE=1 ctest -L golden";
    EXPECT_EQ(output, read(golden_)) << "if this is what it should be: GOLDEN_UPDATE=1 ctest -L golden";
  }

 private:
  fs::path document_;
  fs::path golden_;
  const Stage& stage_;
};

/// The program ends where a document asks for a stage that there is not.
const Stage& stage_named(const std::string& name, const fs::path& document) {
  const Stage* stage = find_stage(name);
  if (stage == nullptr) {
    std::fprintf(stderr, "%s asks for the unknown stage %s\n", document.c_str(), name.c_str());
    std::exit(2);
  }
  return *stage;
}

std::vector<std::string> stages_asked_for(const fs::path& document) {
  std::istringstream first_line(read(document).substr(0, read(document).find('\n')));
  std::string word;
  first_line >> word >> word;
  if (word != "golden:") return {};
  return {std::istream_iterator<std::string>(first_line), {}};
}

std::vector<fs::path> documents_in(const fs::path& folder) {
  std::vector<fs::path> result;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".tex") result.push_back(entry.path());
  std::ranges::sort(result);
  return result;
}

/// In a filter of tests, `-` begins what is left out.
std::string suite_name(const fs::path& document) {
  std::string name = document.stem().string();
  std::ranges::replace(name, '-', '_');
  return name;
}

void add_tests(const fs::path& document, const fs::path& golden_folder, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const Stage& stage = stage_named(name, document);
    fs::path golden = golden_folder / document.stem().concat("." + name);
    testing::RegisterTest(suite_name(document).c_str(), name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                          [=, &stage]() -> testing::Test* { return new GoldenTest(document, golden, stage); });
  }
}

void add_all_tests() {
  const fs::path golden(TEXBRDF_GOLDEN);
  for (const fs::path& model : documents_in(fs::path(TEXBRDF_TEST_DATA) / "models"))
    add_tests(model, golden / "models", {"types", "ir", "glsl", "brdf", "print"});
  for (const fs::path& document : documents_in(golden / "documents"))
    add_tests(document, golden / "documents", stages_asked_for(document));
}

}  // namespace
}  // namespace texbrdf::test

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  texbrdf::test::add_all_tests();
  return RUN_ALL_TESTS();
}
