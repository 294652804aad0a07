#include <gtest/gtest.h>

#include <algorithm>

#include "support/parse_equation.h"
#include "support/random.h"
#include "syntax/print_source.h"
#include "syntax/print_tree_text.h"

namespace texbrdf {
namespace {

std::string repeated(std::string_view piece, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += piece;
  return text;
}

uint32_t height(const ParsedBlock& block) {
  std::vector<uint32_t> heights(block.tree.size());
  for (uint32_t i = 0; i < block.tree.size(); ++i) {
    for (const NodeId child : block.tree.children(NodeId{i})) {
      EXPECT_LT(child.value, i);
      heights[i] = std::max(heights[i], heights[child.value] + 1);
    }
  }
  return heights.empty() ? 0 : *std::max_element(heights.begin(), heights.end());
}

struct Nesting {
  const char* name;
  const char* opening;
  const char* middle;
  const char* closing;
  uint32_t levels;  ///< that one repetition adds to the tree
};

constexpr Nesting kNestings[] = {
    {"parentheses", "(", "1", ")", 1},
    {"braces", "{", "1", "}", 1},
    {"sums", "1+", "1", "", 1},
    {"powers", "2^", "1", "", 1},
    {"signs", "-", "1", "", 1},
    {"functions", "\\sin ", "1", "", 1},
    {"signed_functions", "\\sin -", "1", "", 2},
    {"roots", "\\sqrt ", "1", "", 1},
    {"indices", "\\sqrt[", "1", "]{2}", 1},
    {"fractions", "\\frac{1}{", "1", "}", 1},
    {"calls", "g(", "1", ")", 1},
    {"extrema", "\\max(1,", "1", ")", 1},
    {"juxtaposed", "x ", "x", "", 1},
    {"vectors", "\\vec{", "n", "}", 1},
    {"subscripts", "x_{", "n", "}", 1},
    {"subscript_groups", "x_{{", "n", "}}", 2},
};

class Depth : public testing::TestWithParam<Nesting> {};

TEST_P(Depth, reads_trees_up_to_the_limit) {
  const Nesting& nesting = GetParam();
  const int count = static_cast<int>((kMaxTreeHeight - 10) / nesting.levels);
  const ParsedBlock block =
      test::parse_equation("f=" + repeated(nesting.opening, count) + nesting.middle + repeated(nesting.closing, count));
  const auto is_error = [](const Diagnostic& d) { return d.severity == Severity::Error; };
  EXPECT_TRUE(std::none_of(block.diagnostics.begin(), block.diagnostics.end(), is_error));
  ASSERT_EQ(block.definitions.size(), 1u);
  EXPECT_TRUE(block.definitions[0].readable);
  EXPECT_LE(height(block), kMaxTreeHeight);
  EXPECT_FALSE(print_source(block, block.definitions[0]).empty());
}

TEST_P(Depth, reports_what_is_deeper_once) {
  const Nesting& nesting = GetParam();
  for (const int count : {1001, 1100, 100'000}) {
    for (const bool closed : {true, false}) {
      const std::string end = closed ? repeated(nesting.closing, count) : "";
      const ParsedBlock block = test::parse_equation("f=" + repeated(nesting.opening, count) + nesting.middle + end);
      std::vector<Code> errors;
      for (const Diagnostic& diagnostic : block.diagnostics) {
        if (diagnostic.severity == Severity::Error) errors.push_back(diagnostic.code);
      }
      ASSERT_EQ(errors.size(), 1u) << count << closed << test::diagnostics_text(block).substr(0, 300);
      const bool is_open = !closed && *nesting.closing != '\0';
      const bool is_too_long = block.text.size() > kMaxBlockBytes;
      EXPECT_EQ(errors[0], is_too_long ? Code::BlockTooLong : is_open ? Code::UnclosedBracket : Code::TooDeep) << count;
      EXPECT_LE(height(block), kMaxTreeHeight);
      for (const DefinitionSyntax& definition : block.definitions) {
        EXPECT_FALSE(definition.readable);
        print_source(block, definition);
      }
      print_tree_text(block);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Depth, testing::ValuesIn(kNestings),
                         [](const auto& param_info) { return param_info.param.name; });

TEST(ParserAnyBytes, give_a_tree_of_ids_in_range) {
  constexpr std::string_view kPieces[] = {"\\begin{equation}",
                                          "\\end{equation}",
                                          "f",
                                          "=",
                                          "(",
                                          ")",
                                          "{",
                                          "}",
                                          "[",
                                          "]",
                                          "+",
                                          "-",
                                          "*",
                                          "/",
                                          "^",
                                          "_",
                                          ",",
                                          "&",
                                          "1",
                                          ".5",
                                          "x",
                                          "\\vec{",
                                          "\\vec",
                                          "\\text{",
                                          "\\text",
                                          "\\frac",
                                          "\\sqrt",
                                          "\\exp",
                                          "\\max",
                                          "\\alpha",
                                          "\\foo",
                                          "%",
                                          "\n",
                                          "\\label{",
                                          "\\left",
                                          "\\\\",
                                          "\xFF",
                                          "ω",
                                          "\\begin{x}",
                                          "\\end{x}",
                                          " ",
                                          std::string_view("\0", 1),
                                          "\\cdot",
                                          "\\times"};
  test::Random random(2024);
  for (int round = 0; round < 20'000; ++round) {
    std::string document = random.chance(0.9) ? "\\begin{equation}f=" : "";
    const size_t pieces = 1 + random.below(25);
    for (size_t i = 0; i < pieces; ++i) document += kPieces[random.below(std::size(kPieces))];
    if (random.chance(0.8)) document += "\\end{equation}";
    for (const BlockExtent& extent : scan_blocks(document)) {
      const ParsedBlock block =
          parse_block(std::string_view(document).substr(extent.whole.begin, extent.whole.size()), extent);
      height(block);
      for (uint32_t i = 0; i < block.tree.size(); ++i) {
        const Node& node = block.tree.node(NodeId{i});
        ASSERT_LT(node.first_token, node.end_token) << document;
        ASSERT_LE(node.end_token, block.tokens.size()) << document;
        ASSERT_LT(node.token, block.tokens.size()) << document;
      }
      for (const Diagnostic& diagnostic : block.diagnostics) {
        ASSERT_LE(diagnostic.where.span.begin, diagnostic.where.span.end) << document;
        ASSERT_LE(diagnostic.where.span.end, block.text.size()) << document;
        message(diagnostic);
      }
      for (const DefinitionSyntax& definition : block.definitions) {
        const bool has_error =
            std::any_of(block.diagnostics.begin() + definition.first_diagnostic,
                        block.diagnostics.begin() + definition.end_diagnostic,
                        [](const Diagnostic& diagnostic) { return diagnostic.severity == Severity::Error; });
        ASSERT_FALSE(has_error && definition.readable) << document;
        ASSERT_TRUE(has_error || definition.readable || extent.ended_by != BlockEnd::Closed) << document;
        print_source(block, definition);
      }
      ASSERT_FALSE(block.definitions.empty() && block.diagnostics.empty()) << document;
      print_tree_text(block);
      print_tokens_text(block);
    }
  }
}

}  // namespace
}  // namespace texbrdf
