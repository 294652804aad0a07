#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>

#include "ir/passes/passes.h"
#include "ir/print.h"
#include "ir/validate.h"
#include "support/read_graph.h"

// tests/data/passes/<pass>.txt: cases of one pass, each `== what it shows`, the graph before, `--`, the graph after.
// GOLDEN_UPDATE=1 rewrites what comes after.

namespace texbrdf::ir {
namespace {

namespace fs = std::filesystem;

struct Case {
  std::string title;
  std::string before;
  std::string after;
};

fs::path case_folder() {
  return fs::path(TEXBRDF_TEST_DATA) / "passes";
}

std::vector<Case> read_cases(const fs::path& path) {
  std::vector<Case> cases;
  std::ifstream file(path);
  bool after = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("== ")) {
      cases.push_back({.title = line.substr(3), .before = "", .after = ""});
      after = false;
    } else if (line == "--") {
      after = true;
    } else if (!cases.empty() && !line.empty()) {
      (after ? cases.back().after : cases.back().before) += line + "\n";
    }
  }
  return cases;
}

void write_cases(const fs::path& path, const std::vector<Case>& cases) {
  std::ofstream file(path);
  for (const Case& one : cases) {
    file << (&one == cases.data() ? "" : "\n") << "== " << one.title << "\n" << one.before << "--\n" << one.after;
  }
}

std::map<std::string, Graph (*)(const Graph&)> passes_by_name() {
  std::map<std::string, Graph (*)(const Graph&)> passes;
  for (const Pass& pass : evaluation_passes()) passes.emplace(pass.name, pass.run);
  for (const Pass& pass : emission_passes()) passes.emplace(pass.name, pass.run);
  return passes;
}

class PassCases : public testing::TestWithParam<std::string> {};

TEST_P(PassCases, TurnEachGraphIntoTheOneBelow) {
  const auto pass = passes_by_name().at(GetParam());
  const fs::path path = case_folder() / (GetParam() + ".txt");
  std::vector<Case> cases = read_cases(path);
  ASSERT_FALSE(cases.empty()) << path;
  const bool update = std::getenv("GOLDEN_UPDATE") != nullptr;
  for (Case& one : cases) {
    SCOPED_TRACE(one.title);
    const Graph before = test::read_graph(one.before);
    ASSERT_EQ(find_fault(before), std::nullopt);
    const Graph after = pass(before);
    EXPECT_EQ(find_fault(after), std::nullopt);
    if (update) {
      one.after = print_graph(after);
    } else {
      EXPECT_EQ(print_graph(after), one.after);
    }
  }
  if (update) write_cases(path, cases);
}

std::vector<std::string> pass_names() {
  std::vector<std::string> names;
  for (const auto& [name, pass] : passes_by_name()) names.push_back(name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(All, PassCases, testing::ValuesIn(pass_names()),
                         [](const auto& parameter) { return parameter.param; });

}  // namespace
}  // namespace texbrdf::ir
