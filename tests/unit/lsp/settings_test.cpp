#include "lsp/settings.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace texbrdf::lsp {
namespace {

using nlohmann::json;

Settings applied(const char* object, std::vector<std::string> expected_problems = {}) {
  Settings settings;
  EXPECT_EQ(apply_settings(json::parse(object), settings), expected_problems) << object;
  return settings;
}

TEST(Settings, EverythingIsOnUnlessSet) {
  const Settings settings;
  for (std::size_t i = 0; i < kFeatureCount; ++i) EXPECT_TRUE(settings.shows(static_cast<Feature>(i)));
  EXPECT_EQ(settings.diagnostic_delivery, DiagnosticDelivery::Push);
  EXPECT_EQ(applied("{}"), settings);
  EXPECT_EQ(applied("null"), settings);
}

TEST(Settings, ASectionNestedOrDottedOrWhole) {
  for (const char* object :
       {R"({"features":{"hover":false}})", R"({"features.hover":false})", R"({"texbrdf":{"features":{"hover":false}}})",
        R"({"texbrdf":{"features.hover":false},"other":{"x":1}})", R"({"features":{"hover":false,"rename":null}})"}) {
    const Settings settings = applied(object);
    EXPECT_FALSE(settings.shows(Feature::Hover)) << object;
    EXPECT_TRUE(settings.shows(Feature::Rename)) << object;
  }
}

TEST(Settings, Choices) {
  EXPECT_EQ(applied(R"({"diagnostics":{"delivery":"pull","hints":"off"}})").diagnostic_delivery,
            DiagnosticDelivery::Pull);
  EXPECT_EQ(applied(R"({"diagnostics":{"hints":"warning"}})").hint_severity, HintSeverity::Warning);
  EXPECT_EQ(applied(R"({"log":{"level":"trace"}})").log_level, LogLevelChoice::Trace);
  EXPECT_FALSE(applied(R"({"inlayHint":{"constantValues":false}})").inlay_constant_values);
}

TEST(Settings, WhatIsNotUnderstoodIsToldAndChangesNothing) {
  EXPECT_EQ(applied(R"({"features":{"hovver":false},"x":1})",
                    {"there is no setting texbrdf.features.hovver", "there is no setting texbrdf.x"}),
            Settings());
  EXPECT_EQ(applied(R"({"features":{"hover":"no"}})", {"texbrdf.features.hover has to be true or false"}), Settings());
  EXPECT_EQ(applied(R"({"diagnostics":{"delivery":3}})",
                    {"texbrdf.diagnostics.delivery has to be one of `\"push\"`, `\"pull\"`"}),
            Settings());
  EXPECT_EQ(applied(R"([])", {"the section texbrdf has to be an object"}), Settings());
  EXPECT_EQ(applied(R"({"a":{"a":{"a":{"a":{"a":{"a":1}}}}}})", {"there is no setting texbrdf.a.a.a.a"}), Settings());
}

TEST(Settings, AFeatureForEachMethod) {
  EXPECT_EQ(feature_of("textDocument/hover"), Feature::Hover);
  EXPECT_EQ(feature_of("textDocument/prepareRename"), Feature::Rename);
  EXPECT_EQ(feature_of("textDocument/semanticTokens/full/delta"), Feature::SemanticTokens);
  EXPECT_FALSE(feature_of("textDocument/diagnostic"));  // answers with an empty list, not with null
  EXPECT_FALSE(feature_of("shutdown"));
  EXPECT_FALSE(feature_of(""));
}

/// The page shows the table as it is.
TEST(Settings, AreDocumented) {
  std::ifstream file(std::string(TEXBRDF_SOURCE_DIR) + "/docs/lsp.md");
  std::stringstream page;
  page << file.rdbuf();
  for (const SettingRow& row : setting_rows()) {
    std::ostringstream line;
    line << "| `texbrdf." << row.key << "` | " << row.type << " | `" << row.standard << "` | " << row.description
         << " |\n";
    EXPECT_NE(page.str().find(line.str()), std::string::npos) << line.str();
  }
}

}  // namespace
}  // namespace texbrdf::lsp
