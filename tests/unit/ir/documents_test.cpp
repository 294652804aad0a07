#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "ir/passes/passes.h"
#include "ir/print.h"
#include "ir/validate.h"
#include "support/linkable_document.h"
#include "support/random_document.h"

// tests/data/ir/<name>.tex: a document; <name>.ir: its linked program. GOLDEN_UPDATE=1 rewrites the latter.

namespace texbrdf::ir {
namespace {

namespace fs = std::filesystem;

std::string read_text(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

std::vector<std::string> documents(const char* folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(fs::path(TEXBRDF_TEST_DATA) / folder)) {
    if (entry.path().extension() == ".tex") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string test_name(const testing::TestParamInfo<std::string>& parameter) {
  std::string name = parameter.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

class SmallDocuments : public testing::TestWithParam<std::string> {};

TEST_P(SmallDocuments, LinkToTheProgramBeside) {
  const fs::path base = fs::path(TEXBRDF_TEST_DATA) / "ir" / GetParam();
  const test::LinkableDocument document(read_text(base.string() + ".tex"));
  const Result<Program> program = document.link();
  ASSERT_TRUE(program) << program.error();
  EXPECT_EQ(find_fault(*program), std::nullopt);
  const std::string printed = print_program(*program);
  if (std::getenv("GOLDEN_UPDATE") != nullptr) std::ofstream(base.string() + ".ir") << printed;
  EXPECT_EQ(printed, read_text(base.string() + ".ir"));
}

INSTANTIATE_TEST_SUITE_P(All, SmallDocuments, testing::ValuesIn(documents("ir")), test_name);

/// Links, flattens and runs every pass; each step must be valid.
void expect_valid_at_every_step(const std::string& text) {
  const Result<Program> program = test::LinkableDocument(text).link();
  ASSERT_TRUE(program) << program.error();
  EXPECT_EQ(find_fault(*program), std::nullopt);
  EXPECT_EQ(find_fault(run_passes(*program, emission_passes())), std::nullopt);
  Result<Graph> flat = flatten(*program);
  ASSERT_TRUE(flat) << flat.error();
  EXPECT_EQ(find_fault(*flat), std::nullopt);
  Graph graph = *flat;
  for (const Pass& pass : evaluation_passes()) {
    graph = pass.run(graph);
    EXPECT_EQ(find_fault(graph), std::nullopt) << pass.name;
  }
  for (const Value& value : graph.values()) {
    EXPECT_TRUE(value.op != Op::Reference && value.op != Op::Call && value.op != Op::Formal);
    EXPECT_TRUE(value.op != Op::Convention || value.operand_count == 0);
  }
}

class Models : public testing::TestWithParam<std::string> {};

TEST_P(Models, AreValidAtEveryStep) {
  expect_valid_at_every_step(read_text(fs::path(TEXBRDF_TEST_DATA) / "models" / (GetParam() + ".tex")));
}

INSTANTIATE_TEST_SUITE_P(All, Models, testing::ValuesIn(documents("models")), test_name);

class RandomDocuments : public testing::TestWithParam<int> {};

TEST_P(RandomDocuments, AreValidAtEveryStep) {
  for (uint64_t i = 0; i < 25; ++i) {
    const uint64_t seed = static_cast<uint64_t>(GetParam()) * 25 + i;
    SCOPED_TRACE(seed);
    expect_valid_at_every_step(test::random_document(seed));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomDocuments, testing::Range(0, 4));

/// How many values of the op the model's evaluation graph has after all passes.
uint32_t count_after_passes(const char* model, Op op) {
  const auto program =
      test::LinkableDocument(read_text(fs::path(TEXBRDF_TEST_DATA) / "models" / (std::string(model) + ".tex"))).link();
  const Graph graph = run_passes(*flatten(*program), evaluation_passes());
  const auto values = graph.values();
  return static_cast<uint32_t>(
      std::count_if(values.begin(), values.end(), [op](const Value& value) { return value.op == op; }));
}

TEST(Passes, LeaveNoInverseFunctionWhereOnlyCosinesOfAnglesAreUsed) {
  for (const char* model : {"blinn-phong", "cook-torrance", "ward", "duer", "ashikhmin-shirley", "kajiya-kay"}) {
    EXPECT_EQ(count_after_passes(model, Op::Arccos), 0u) << model;
    EXPECT_EQ(count_after_passes(model, Op::Arctan2), 0u) << model;
  }
}

TEST(Passes, KeepThePowerWhoseExponentIsAParameter) {
  EXPECT_EQ(count_after_passes("edwards-2006", Op::Power), 1u);
  EXPECT_EQ(count_after_passes("duer", Op::Power), 0u);
}

TEST(Passes, GiveTheSameTextEachTime) {
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const std::string text = test::random_document(seed);
    const auto print = [&text] {
      const auto program = test::LinkableDocument(text).link();
      return print_program(run_passes(*program, emission_passes())) +
             print_graph(run_passes(*flatten(*program), evaluation_passes()));
    };
    EXPECT_EQ(print(), print()) << seed;
  }
}

TEST(Passes, ChangeNothingWhenRunAgain) {
  for (uint64_t seed = 0; seed < 50; ++seed) {
    const auto program = test::LinkableDocument(test::random_document(seed)).link();
    const Graph once = run_passes(*flatten(*program), evaluation_passes());
    const Graph twice = run_passes(once, evaluation_passes());
    EXPECT_LE(twice.size(), once.size()) << seed;
    EXPECT_EQ(print_graph(run_passes(twice, evaluation_passes())), print_graph(twice)) << seed;
  }
}

}  // namespace
}  // namespace texbrdf::ir
