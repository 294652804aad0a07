#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "support/parse_equation.h"
#include "support/random.h"
#include "syntax/print_tree_svg.h"
#include "syntax/print_tree_text.h"
#include "syntax/tree_layout.h"

namespace texbrdf {
namespace {

NodeLabel token_label(const ParsedBlock& block, NodeId id) {
  return {std::string(block.token_text(block.tree.node(id).token)),
          std::string(node_kind_name(block.tree.node(id).kind))};
}

bool overlap(const TreeBox& a, const TreeBox& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

void expect_tidy(const SyntaxTree& tree, NodeId root, const NodeLabeller& label) {
  std::vector<TreeBox> boxes = layout_tree(tree, root, label);
  std::vector<const TreeBox*> by_node(tree.size(), nullptr);
  for (const TreeBox& box : boxes) by_node[box.node.value] = &box;
  for (const TreeBox& parent : boxes) {
    EXPECT_GE(parent.x, -1e-9);
    const std::span<const NodeId> children = tree.children(parent.node);
    if (children.empty()) continue;
    const auto centre = [&](NodeId id) { return by_node[id.value]->x + by_node[id.value]->width / 2; };
    EXPECT_NEAR(centre(parent.node), (centre(children.front()) + centre(children.back())) / 2, 1e-6);
    for (size_t i = 1; i < children.size(); ++i) EXPECT_LT(centre(children[i - 1]), centre(children[i]));
    for (const NodeId child : children) EXPECT_GE(by_node[child.value]->y, parent.y + parent.height);
  }
  std::sort(boxes.begin(), boxes.end(), [](const TreeBox& a, const TreeBox& b) { return a.x < b.x; });
  for (size_t i = 0; i < boxes.size(); ++i) {
    for (size_t j = i + 1; j < boxes.size() && boxes[j].x < boxes[i].x + boxes[i].width; ++j) {
      ASSERT_FALSE(overlap(boxes[i], boxes[j]));
    }
  }
}

TEST(TreeLayout, has_no_overlapping_boxes_on_random_trees) {
  test::Random random(5);
  for (int round = 0; round < 300; ++round) {
    // Nodes wait for a parent; a new node takes some of the last ones.
    SyntaxTree tree(std::pmr::get_default_resource());
    std::vector<NodeId> waiting;
    const size_t nodes = 1 + random.below(200);
    const size_t most_children = 1 + random.below(6);
    while (tree.size() < nodes || waiting.size() > 1) {
      const bool finish = tree.size() >= nodes;
      const size_t count = std::min(waiting.size(), finish ? most_children + 1 : random.below(most_children + 1));
      const std::vector<NodeId> children(waiting.end() - static_cast<std::ptrdiff_t>(count), waiting.end());
      waiting.resize(waiting.size() - count);
      waiting.push_back(tree.add(NodeKind::Group, 0, 0, 1, children));
    }
    std::vector<NodeLabel> labels;
    for (uint32_t i = 0; i < tree.size(); ++i) {
      labels.push_back(
          {std::string(random.below(30), 'm'), random.chance(0.5) ? std::string(random.below(30), 'r') : ""});
    }
    expect_tidy(tree, waiting[0], [&](NodeId id) { return labels[id.value]; });
  }
}

TEST(TreeLayout, takes_high_and_wide_trees) {
  for (const std::string_view piece : {"-", "1+", "\\sin "}) {
    std::string equation = "f=";
    for (int i = 0; i < 900; ++i) equation += piece;
    const ParsedBlock block = test::parse_equation(equation + "1");
    expect_tidy(block.tree, block.definitions.at(0).node, [&](NodeId id) { return token_label(block, id); });
  }
  std::string wide = "f=g(1";
  for (int i = 0; i < 5000; ++i) wide += ",1";
  const ParsedBlock block = test::parse_equation(wide + ")");
  expect_tidy(block.tree, block.definitions.at(0).node, [&](NodeId id) { return token_label(block, id); });
}

TEST(TreeLayout, cuts_long_labels) {
  const ParsedBlock block = test::parse_equation("f=1");
  const NodeLabeller endless = [](NodeId) { return NodeLabel{std::string(100'000, 'x'), ""}; };
  for (const TreeBox& box : layout_tree(block.tree, block.definitions.at(0).node, endless)) EXPECT_LT(box.width, 1000);
}

/// Checks nesting of elements and that no character stands that XML forbids.
testing::AssertionResult is_well_formed(std::string_view xml) {
  std::vector<std::string_view> open;
  for (size_t at = 0; at < xml.size();) {
    const auto c = static_cast<unsigned char>(xml[at]);
    if (c < 0x20 && c != '\n' && c != '\t') return testing::AssertionFailure() << "control character at " << at;
    if (c == '&') {
      const size_t end = xml.find(';', at);
      const std::string_view entity = xml.substr(at, end - at + 1);
      const bool known = entity == "&amp;" || entity == "&lt;" || entity == "&gt;" || entity == "&quot;";
      if (!known) return testing::AssertionFailure() << "entity at " << at;
    }
    if (c != '<') {
      ++at;
      continue;
    }
    const size_t end = xml.find('>', at);
    if (end == std::string_view::npos) return testing::AssertionFailure() << "open tag at " << at;
    const std::string_view tag = xml.substr(at + 1, end - at - 1);
    at = end + 1;
    if (tag.starts_with("?") || tag.ends_with("/")) continue;
    if (!tag.starts_with("/")) {
      open.push_back(tag.substr(0, tag.find(' ')));
      continue;
    }
    if (open.empty() || open.back() != tag.substr(1)) return testing::AssertionFailure() << "closing tag at " << at;
    open.pop_back();
  }
  return open.empty() ? testing::AssertionSuccess() : testing::AssertionFailure() << "unclosed " << open.back();
}

TEST(PrintTreeSvg, is_well_formed_for_any_labels) {
  const ParsedBlock block = test::parse_equation("f=\\frac{a}{b}+\\exp(-x)^2");
  std::string all_bytes;
  for (int byte = 0; byte < 256; ++byte) all_bytes += static_cast<char>(byte);
  test::Random random(11);
  const NodeLabeller label = [&](NodeId) {
    std::string text;
    for (int i = 0; i < 20; ++i) text += all_bytes[random.below(256)];
    return NodeLabel{text, "<\"&'>]]>\xEF\xBF\xBF" + text};
  };
  const NodeId root = block.definitions.at(0).node;
  EXPECT_TRUE(
      is_well_formed(print_tree_svg({{all_bytes, &block.tree, root, label}, {"<b>", &block.tree, root, label}})));
  EXPECT_TRUE(is_well_formed(print_tree_svg({})));
}

TEST(PrintTreeSvg, draws_a_box_for_each_node_and_an_edge_to_each_child) {
  const ParsedBlock block = test::parse_equation("f=1+2*x");
  const std::string svg = print_tree_svg(
      {{"f", &block.tree, block.definitions.at(0).node, [&](NodeId id) { return token_label(block, id); }}});
  const auto count = [&](std::string_view piece) {
    size_t found = 0;
    for (size_t at = svg.find(piece); at != std::string::npos; at = svg.find(piece, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("<rect class=\"box\""), 7u);
  EXPECT_EQ(count("<path class=\"edge\""), 6u);
  EXPECT_EQ(count(">*</text>"), 1u);
  EXPECT_EQ(count(">Infix</text>"), 2u);
}

TEST(PrintTreeText, shows_tokens_and_nodes_with_their_ranges) {
  const ParsedBlock block = test::parse_first_block("\\begin{equation}g(x)=-\\sin x_1\\end{equation}");
  EXPECT_EQ(print_tokens_text(block),
            "16-17 Word g\n17-18 OpenParen (\n18-19 Word x\n19-20 CloseParen )\n20-21 Equals =\n21-22 Minus -\n"
            "22-26 Function \\sin\n27-28 Word x\n28-29 Underscore _\n29-30 Number 1\n30-34 End \\end\n");
  EXPECT_EQ(print_tree_text(block),
            "Definition 16-30 =\n"
            "  Signature 16-20 (\n"
            "    Name 16-17 g\n"
            "    Name 18-19 x\n"
            "  Prefix 21-30 -\n"
            "    Function 22-30 \\sin\n"
            "      Name 27-30 x_1\n");
}

}  // namespace
}  // namespace texbrdf
