#pragma once

#include <functional>
#include <string>
#include <vector>

#include "syntax/parsed_block.h"

namespace texbrdf {

/// What a box of the drawing says: the operator or name, and below it a smaller line (its inferred type).
struct NodeLabel {
  std::string title;
  std::string subtitle;
};

/// A box of the layout, in px.
struct TreeBox {
  NodeId node;
  double x = 0, y = 0, width = 0, height = 0;
};

using NodeLabeller = std::function<NodeLabel(NodeId)>;

/// Tidy layout, root on top: no two boxes overlap, parents are centred over their children.
std::vector<TreeBox> layout_tree(const SyntaxTree& tree, NodeId root, const NodeLabeller& label);

/// A heading and the tree of one definition; labels come from outside because the tree knows no types.
struct TreeDrawing {
  std::string heading;
  const SyntaxTree* tree = nullptr;
  NodeId root;
  NodeLabeller label;
};

/// One SVG document, the drawings below each other. Valid XML for any labels.
std::string print_tree_svg(const std::vector<TreeDrawing>& drawings);

}  // namespace texbrdf
