#include <gtest/gtest.h>

#include <cctype>
#include <set>

#include "diagnostics/diagnostic.h"
#include "diagnostics/render_catalogue.h"

namespace texbrdf {
namespace {

TEST(Catalogue, has_every_code_once_and_in_order) {
  std::set<std::string_view> names;
  for (size_t i = 0; i < catalogue().size(); ++i) {
    const CatalogueEntry& entry = catalogue()[i];
    EXPECT_TRUE(i == 0 || catalogue()[i - 1].code < entry.code);
    EXPECT_TRUE(names.insert(entry.name).second) << entry.name;
    EXPECT_EQ(catalogue_entry(entry.code).name, entry.name);
  }
}

TEST(Catalogue, keeps_to_its_wording) {
  for (const CatalogueEntry& entry : catalogue()) {
    ASSERT_FALSE(entry.text.empty());
    EXPECT_FALSE(std::isupper(static_cast<unsigned char>(entry.text[0]))) << entry.text;
    EXPECT_NE(entry.text.back(), '.') << entry.text;
    EXPECT_EQ(entry.explanation.back(), '.') << entry.explanation;
  }
}

TEST(Catalogue, is_one_page_with_an_anchor_for_each_code) {
  const std::string page = render_catalogue();
  for (const CatalogueEntry& entry : catalogue()) {
    EXPECT_NE(page.find("<a id=\"" + code_name(entry.code) + "\"></a>"), std::string::npos) << entry.name;
    EXPECT_NE(page.find(entry.explanation), std::string::npos) << entry.name;
  }
}

TEST(Diagnostic, forms_its_message_from_its_arguments) {
  const Diagnostic wrong_end = make_diagnostic(Code::WrongEnd, {}, {"\\begin{equation}", "\\end{align}"});
  EXPECT_EQ(message(wrong_end), "`\\begin{equation}` is closed by `\\end{align}`");
  EXPECT_EQ(code_name(Code::WrongEnd), "E2006");
  EXPECT_EQ(severity_name(make_diagnostic(Code::PowerInFunction, {}).severity), "information");
  EXPECT_EQ(severity_name(make_diagnostic(Code::IgnoredAmpersand, {}).severity), "warning");
}

}  // namespace
}  // namespace texbrdf
