// `bench_edits BLOCKS EDITS`: opens a document of so many chained equations and changes a digit so many times, reading
// the diagnostics after each. instructions_per_edit.py runs it under callgrind.
#include <cstdlib>
#include <string>

#include "analysis/document.h"
#include "features/diagnostics.h"

int main(int argc, char** argv) {
  if (argc != 3) return EXIT_FAILURE;
  const int blocks = std::atoi(argv[1]);
  const int edits = std::atoi(argv[2]);
  std::string text = "\\begin{equation}a_{0} = 0.5\\end{equation}\n";
  for (int i = 1; i < blocks; ++i) {
    text += "Term.\n\\begin{equation}\n  a_{" + std::to_string(i) + "} = a_{" + std::to_string(i - 1) +
            "} * \\theta_h + 0.25\n\\end{equation}\n";
  }
  text += "\\begin{equation}f = a_{" + std::to_string(blocks - 1) + "}\\end{equation}\n";
  texbrdf::Document document(text);
  document.prepare_for_edits();
  size_t at = text.size() / 2;
  for (int i = 0; i < edits; ++i) {
    at = text.find("0.25", at + 1);
    if (at == std::string::npos) at = text.find("0.25");
    const auto digit = static_cast<uint32_t>(at + 3);
    document.replace({digit, digit + 1}, std::to_string(i % 10));
    texbrdf::features::diagnostics(document.snapshot(), nullptr);
  }
  return EXIT_SUCCESS;
}
