// Every code of the catalogue has a document that provokes it: tests/data/diagnostics/<code>.tex, whose first line says
// which codes the document gives, in order: `% expect: E3001 E3001`.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "analysis/document.h"
#include "diagnostics/diagnostic.h"
#include "features/numeric_diagnostics.h"

namespace texbrdf {
namespace {

namespace fs = std::filesystem;

/// Codes whose document would not be worth keeping as a file, made here.
std::map<std::string, std::string> generated_documents() {
  const std::string long_body(std::size_t{1} << 20, '1');
  return {{"E2017", "% expect: E2017\n\\begin{equation}f = " + long_body + "\\end{equation}\n"}};
}

std::map<std::string, std::string> documents() {
  std::map<std::string, std::string> all = generated_documents();
  for (const fs::directory_entry& entry : fs::directory_iterator(TEXBRDF_TEST_DATA "/diagnostics")) {
    std::ifstream file(entry.path(), std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    all[entry.path().stem().string()] = text.str();
  }
  return all;
}

std::vector<std::string> expected_codes(const std::string& document) {
  const std::string prefix = "% expect: ";
  std::istringstream first_line(document.substr(0, document.find('\n')));
  std::vector<std::string> codes;
  if (!first_line.str().starts_with(prefix)) return codes;
  first_line.ignore(static_cast<std::streamsize>(prefix.size()));
  for (std::string code; first_line >> code;) codes.push_back(code);
  return codes;
}

/// No file is read here: what cannot be included says so by its name.
std::vector<IncludeProblem> include_problems(const Document& document) {
  const std::map<std::string, Code> problems = {
      {"absent", Code::FileNotFound}, {"itself", Code::CircularInclusion}, {"../outside", Code::OutsideWorkspace}};
  std::vector<IncludeProblem> found;
  for (const IncludeTarget& target : document.includes()) {
    const auto problem = problems.find(target.path);
    if (problem != problems.end()) found.push_back({FileId{}, target, problem->second, target.path});
  }
  return found;
}

TEST(Catalogue, EveryCodeHasADocumentThatProvokesIt) {
  const std::map<std::string, std::string> all = documents();
  for (const CatalogueEntry& entry : catalogue()) {
    EXPECT_TRUE(all.contains(code_name(entry.code))) << code_name(entry.code) << " (" << entry.name << ") has none";
  }
}

TEST(Catalogue, TheDocumentsGiveExactlyTheCodesTheyAnnounce) {
  for (const auto& [code, text] : documents()) {
    const std::vector<std::string> expected = expected_codes(text);
    EXPECT_NE(std::find(expected.begin(), expected.end(), code), expected.end()) << code << " does not announce itself";
    Document document(text);
    document.set_include_problems(include_problems(document));
    std::vector<std::string> given;
    for (const Diagnostic& diagnostic : features::all_diagnostics(document.snapshot())) {
      given.push_back(code_name(diagnostic.code));
      EXPECT_EQ(message(diagnostic).find("{0}"), std::string::npos) << message(diagnostic);
    }
    EXPECT_EQ(given, expected) << code;
  }
}

TEST(Catalogue, CodesAreUniqueAndSorted) {
  std::set<std::string_view> names;
  int last = -1;
  for (const CatalogueEntry& entry : catalogue()) {
    EXPECT_GT(static_cast<int>(entry.code), last) << entry.name;
    last = static_cast<int>(entry.code);
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_FALSE(entry.explanation.empty()) << entry.name;
    EXPECT_FALSE(entry.text.ends_with('.')) << entry.name;
  }
}

}  // namespace
}  // namespace texbrdf
