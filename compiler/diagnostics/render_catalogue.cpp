#include "diagnostics/render_catalogue.h"

#include <array>
#include <string_view>

#include "diagnostics/diagnostic.h"

namespace texbrdf {
namespace {

struct Stage {
  uint16_t first_number;
  std::string_view title;
};

constexpr std::array<Stage, 8> kStages = {{{0, "Documents and the command line"},
                                           {1000, "Tokens"},
                                           {2000, "Syntax"},
                                           {3000, "Names"},
                                           {4000, "Types"},
                                           {5000, "Physics"},
                                           {6000, "Code generation"},
                                           {7000, "Pictures"}}};

constexpr uint16_t kCodesPerStage = 1000;

void write_entry(std::string& page, const CatalogueEntry& entry) {
  const std::string code = code_name(entry.code);
  page += "\n### <a id=\"" + code + "\"></a>" + code + " " + std::string(entry.name) + "\n\n";
  page += std::string(severity_name(entry.severity)) + ": " + std::string(entry.text) + "\n\n";
  page += std::string(entry.explanation) + "\n";
}

}  // namespace

std::string render_catalogue() {
  std::string page =
      "# Diagnostics\n\n"
      "Every message of the compiler, by code. Codes are stable and never used for anything else.\n"
      "`{0}`, `{1}` … stand for what the message names. This page is made from compiler/diagnostics/catalogue.def.\n";
  for (const Stage& stage : kStages) {
    bool has_title = false;
    for (const CatalogueEntry& entry : catalogue()) {
      const auto number = static_cast<uint16_t>(entry.code);
      if (number < stage.first_number || number >= stage.first_number + kCodesPerStage) continue;
      if (!has_title) page += "\n## " + std::string(stage.title) + "\n";
      has_title = true;
      write_entry(page, entry);
    }
  }
  return page;
}

}  // namespace texbrdf
