#include "scene_json/json_tree.h"

#include <gtest/gtest.h>

namespace texbrdf::scene_json {
namespace {

JsonTree tree_of(std::string_view text) {
  auto parsed = parse_json(text);
  const auto* fault = std::get_if<JsonFault>(&parsed);
  EXPECT_EQ(fault, nullptr) << (fault != nullptr ? fault->message : "");
  return fault == nullptr ? std::get<JsonTree>(std::move(parsed)) : JsonTree();
}

std::string fault_of(std::string_view text) {
  const auto parsed = parse_json(text);
  const auto* fault = std::get_if<JsonFault>(&parsed);
  return fault == nullptr ? "none" : std::to_string(fault->span.begin) + ": " + fault->message;
}

TEST(JsonTree, ValuesKnowTheirPlaces) {
  const std::string text = "\xEF\xBB\xBF { \"a\" : [1, -2.5e1,\n true], \"b c\":{\"d\":\"x\\\"y\"},\"e\":null}";
  const JsonTree tree = tree_of(text);
  const std::vector<std::pair<std::string, std::string>> expected = {{"", text.substr(4)},
                                                                     {"a", "[1, -2.5e1,\n true]"},
                                                                     {"a[0]", "1"},
                                                                     {"a[1]", "-2.5e1"},
                                                                     {"a[2]", "true"},
                                                                     {"[\"b c\"]", "{\"d\":\"x\\\"y\"}"},
                                                                     {"[\"b c\"].d", "\"x\\\"y\""},
                                                                     {"e", "null"}};
  ASSERT_EQ(tree.size(), expected.size());
  for (uint32_t i = 0; i < tree.size(); ++i) {
    const Span span = tree[{i}].span;
    EXPECT_EQ(tree.path({i}), expected[i].first);
    EXPECT_EQ(text.substr(span.begin, span.size()), expected[i].second);
  }
  EXPECT_EQ(tree[{3}].number, -25);
  EXPECT_FALSE(tree[{3}].whole);
  EXPECT_TRUE(tree[{2}].whole);
  EXPECT_EQ(tree[{6}].text, "x\"y");
  EXPECT_EQ(text.substr(tree[{7}].key_span.begin, 3), "\"e\"");
}

TEST(JsonTree, StringsMayHoldLineBreaks) {
  const std::string text = "{\"code\": \"a\n\tb\r\n\\n\", \"x\": tru}";
  const JsonTree tree = tree_of("{\"code\": \"a\n\tb\r\n\\n\", \"x\": 1}");
  EXPECT_EQ(tree[{1}].text, "a\n\tb\r\n\n");
  EXPECT_EQ(tree[{2}].span.begin, text.find("tru"));
  EXPECT_EQ(fault_of(text), std::to_string(text.find("tru") + 3) + ": no JSON: invalid literal");
}

TEST(JsonTree, FaultsHavePlaceAndReason) {
  EXPECT_EQ(fault_of(""), "0: no JSON: unexpected end of input; expected '[', '{', or a literal");
  EXPECT_EQ(fault_of("{\"a\":1,}"), "7: no JSON: unexpected '}'; expected string literal");
  EXPECT_EQ(fault_of("[1e999]"), "5: no JSON: number overflow parsing '1e999'");
  EXPECT_EQ(fault_of("{\"a\":1,\"a\":2}"), "7: the key `a` stands here twice");
  EXPECT_EQ(fault_of("[1] 2"), "4: no JSON: unexpected number literal; expected end of input");
  EXPECT_EQ(fault_of(std::string(300, '[')), "256: nested deeper than 256");
  EXPECT_EQ(fault_of(std::string(kMaxJsonBytes + 1, ' ')), "0: longer than 8388608 bytes");
  std::string many = "[0";
  for (uint32_t i = 0; i < kMaxJsonValues; ++i) many += ",0";
  EXPECT_EQ(fault_of(many + "]").substr(9), "more than 1000000 values");
}

}  // namespace
}  // namespace texbrdf::scene_json
