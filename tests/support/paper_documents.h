#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace texbrdf::test {

/// The documents in the notation of papers, as paths below the test data without `.tex`; beside each stand its values,
/// `.csv`.
inline std::vector<std::string> paper_documents() {
  std::vector<std::string> found;
  for (const char* folder : {"papers", "publications", "matrices"}) {
    for (const auto& entry : std::filesystem::directory_iterator(std::string(TEXBRDF_TEST_DATA) + "/" + folder)) {
      if (entry.path().extension() == ".tex") found.push_back(folder + ("/" + entry.path().stem().string()));
    }
  }
  std::ranges::sort(found);
  return found;
}

inline std::string paper_test_name(std::string document) {
  std::ranges::replace_if(document, [](char c) { return c == '-' || c == '/'; }, '_');
  return document;
}

}  // namespace texbrdf::test
