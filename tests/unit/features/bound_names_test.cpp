// What an editor is told of names that sums, integrals and derivatives bind, and of names that stand for others.

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "analysis/document.h"
#include "features/definition.h"
#include "features/hover.h"
#include "features/integral_error.h"
#include "features/rename.h"

namespace texbrdf::features {
namespace {

constexpr std::string_view kDocument =
    "$$ a_1 = 1, \\quad a_2 = 2, \\quad k = 5 $$\n"
    "$$ g(x) = x^2 $$\n"
    "$$ f = \\sum_{k=1}^2 k a_k + g'(0.5) + k $$\n";

uint32_t place_of(std::string_view text) {
  return static_cast<uint32_t>(kDocument.find(text));
}

class BoundNames : public testing::Test {
 protected:
  Document document_{std::string(kDocument)};

  std::string_view defined_at(uint32_t offset) {
    const auto link = definition_at(document_.snapshot(), offset);
    return link ? kDocument.substr(link->name.begin, link->name.size()) : "nothing";
  }
  uint32_t place_defined_at(uint32_t offset) {
    const auto link = definition_at(document_.snapshot(), offset);
    return link ? link->name.begin : 0;
  }
  std::string refusal(uint32_t offset) {
    const auto edits = rename(document_.snapshot(), offset, "zeta");
    return edits ? "none" : edits.error();
  }
};

TEST_F(BoundNames, LeadToWhereTheyAreBound) {
  EXPECT_EQ(place_defined_at(place_of("k a_k")), place_of("k=1"));
  EXPECT_EQ(place_defined_at(place_of("k $$\n")), place_of("k = 5"));
}

TEST_F(BoundNames, WithAnIndexLeadToTheFirstOfThem) {
  EXPECT_EQ(defined_at(place_of("a_k")), "a_1");
  EXPECT_EQ(defined_at(place_of("g'")), "g");
  const auto told = hover(document_.snapshot(), place_of("a_k"), Markup::PlainText);
  ASSERT_TRUE(told);
  EXPECT_NE(told->text.find("a_1 = 1"), std::string::npos) << told->text;
}

TEST_F(BoundNames, KeepTheirNames) {
  EXPECT_NE(refusal(place_of("k=1")).find("variable of a sum"), std::string::npos);
  EXPECT_NE(refusal(place_of("a_k")).find("stands for other names"), std::string::npos);
  EXPECT_NE(refusal(place_of("a_2")).find("index or derivative"), std::string::npos);
  EXPECT_NE(refusal(place_of("g(x)")).find("index or derivative"), std::string::npos);
}

TEST_F(BoundNames, AreNotThoseOfTheDocument) {
  const auto edits = rename(document_.snapshot(), place_of("k = 5"), "zeta");
  ASSERT_TRUE(edits) << edits.error();
  EXPECT_EQ(edits->size(), 2U);
}

TEST(InexactIntegrals, AreTold) {
  const auto has_hint = [](std::string_view integrand) {
    Document document("$$ f = \\int_0^1 " + std::string(integrand) + "\\,dx $$");
    return integral_error(document.snapshot(), "f").has_value();
  };
  EXPECT_FALSE(has_hint("\\cos(3 x) e^x"));
  EXPECT_TRUE(has_hint("\\sqrt{|x - 0.3|}"));
}

}  // namespace
}  // namespace texbrdf::features
