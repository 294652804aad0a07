#include "syntax/tree_layout.h"

#include <algorithm>
#include <limits>

#include "source/utf8.h"

namespace texbrdf {
namespace {

// All in px.
constexpr double kPadding = 9;
constexpr double kHorizontalGap = 14;
constexpr double kVerticalGap = 30;
constexpr double kTitleHeight = 28;
constexpr double kBothHeight = 43;
constexpr double kSmallestWidth = 34;

constexpr uint32_t kLongestLabel = 48;     // code points
constexpr uint32_t kLongestHeading = 160;  // code points

std::string cut(std::string_view text, uint32_t longest) {
  uint32_t count = 0;
  for (size_t at = 0; at < text.size(); ++count) {
    if (count == longest) return std::string(text.substr(0, at)) + "…";
    at += code_point_at_front(text.substr(at)).size;
  }
  return std::string(text);
}

/// Left and right edge of a subtree on each of its levels. The root's level is the last element, so that a parent is
/// added and a subtree is merged without moving the others.
struct Contour {
  struct Edges {
    double left = 0;
    double right = 0;
  };
  std::vector<Edges> levels;
  double offset = 0;  ///< to be added to all edges

  size_t depth() const { return levels.size(); }
  Edges& at(size_t level) { return levels[levels.size() - 1 - level]; }
};

/// How far `right` must be moved so that it stands clear of `left`. Both have at least one level.
double needed_shift(Contour& left, Contour& right) {
  double shift = std::numeric_limits<double>::lowest();
  for (size_t level = 0; level < std::min(left.depth(), right.depth()); ++level) {
    const double left_edge = left.at(level).right + left.offset;
    const double right_edge = right.at(level).left + right.offset;
    shift = std::max(shift, left_edge + kHorizontalGap - right_edge);
  }
  return shift;
}

/// The contour around both; costs as much as the flatter of the two is high.
Contour merge(Contour left, Contour right) {
  if (left.depth() >= right.depth()) {
    for (size_t level = 0; level < right.depth(); ++level) {
      left.at(level).right = right.at(level).right + right.offset - left.offset;
    }
    return left;
  }
  for (size_t level = 0; level < left.depth(); ++level) {
    right.at(level).left = left.at(level).left + left.offset - right.offset;
  }
  return right;
}

/// Reingold and Tilford's tidy drawing with boxes of different widths, from the leaves up.
class TreeLayout {
 public:
  TreeLayout(const SyntaxTree& tree, NodeId root, const NodeLabeller& label)
      : tree_(tree), root_(root), nodes_(root.value + size_t{1}) {
    find_levels();
    for (uint32_t i = 0; i <= root.value; ++i) {
      if (nodes_[i].reached) measure(NodeId{i}, label);
    }
    for (uint32_t i = 0; i <= root.value; ++i) {
      if (nodes_[i].reached) place_children(NodeId{i});
    }
  }

  std::vector<TreeBox> boxes() {
    double leftmost = std::numeric_limits<double>::max();
    for (uint32_t i = root_.value + 1; i-- > 0;) {
      if (!nodes_[i].reached) continue;
      for (const NodeId child : tree_.children(NodeId{i})) nodes_[child.value].centre += nodes_[i].centre;
      leftmost = std::min(leftmost, nodes_[i].centre - nodes_[i].width / 2);
    }
    const std::vector<double> tops = level_tops();
    std::vector<TreeBox> boxes;
    for (uint32_t i = 0; i <= root_.value; ++i) {
      const Placed& node = nodes_[i];
      if (!node.reached) continue;
      boxes.push_back({NodeId{i}, node.centre - node.width / 2 - leftmost, tops[node.level], node.width, node.height});
    }
    return boxes;
  }

 private:
  struct Placed {
    bool reached = false;
    uint32_t level = 0;
    double width = 0;
    double height = 0;
    double centre = 0;  ///< relative to the parent's until `boxes`
    Contour contour;
  };

  void find_levels() {
    nodes_[root_.value].reached = true;
    for (uint32_t i = root_.value + 1; i-- > 0;) {
      if (!nodes_[i].reached) continue;
      for (const NodeId child : tree_.children(NodeId{i})) {
        nodes_[child.value].reached = true;
        nodes_[child.value].level = nodes_[i].level + 1;
      }
    }
  }

  void measure(NodeId id, const NodeLabeller& label) {
    const NodeLabel shown = shown_label(label(id));
    Placed& node = nodes_[id.value];
    const double text =
        std::max(text_width(shown.title, kTitleFontSize), text_width(shown.subtitle, kSubtitleFontSize));
    node.width = std::max(text + 2 * kPadding, kSmallestWidth);
    node.height = shown.subtitle.empty() ? kTitleHeight : kBothHeight;
  }

  /// Children side by side as close as their contours allow, the parent over the middle.
  void place_children(NodeId id) {
    Placed& parent = nodes_[id.value];
    const std::span<const NodeId> children = tree_.children(id);
    Contour around;
    for (const NodeId child_id : children) {
      Placed& child = nodes_[child_id.value];
      if (around.depth() == 0) {
        around = std::move(child.contour);
        continue;
      }
      const double shift = needed_shift(around, child.contour);
      child.centre = shift;
      child.contour.offset += shift;
      around = merge(std::move(around), std::move(child.contour));
    }
    if (!children.empty()) {
      const double middle = (nodes_[children.front().value].centre + nodes_[children.back().value].centre) / 2;
      for (const NodeId child_id : children) nodes_[child_id.value].centre -= middle;
      around.offset -= middle;
    }
    around.levels.push_back({-parent.width / 2 - around.offset, parent.width / 2 - around.offset});
    parent.contour = std::move(around);
  }

  std::vector<double> level_tops() const {
    std::vector<double> heights;
    for (const Placed& node : nodes_) {
      if (!node.reached) continue;
      if (heights.size() <= node.level) heights.resize(node.level + size_t{1});
      heights[node.level] = std::max(heights[node.level], node.height);
    }
    std::vector<double> tops(heights.size());
    for (size_t level = 1; level < tops.size(); ++level) {
      tops[level] = tops[level - 1] + heights[level - 1] + kVerticalGap;
    }
    return tops;
  }

  const SyntaxTree& tree_;
  NodeId root_;
  std::vector<Placed> nodes_;
};

}  // namespace

double text_width(std::string_view text, double font_size) {
  constexpr double kMonospaced = 0.605;  // em, DejaVu Sans Mono
  constexpr double kOther = 1.05;        // em, an ideograph or a glyph of a font that stands in
  double width = 0;
  while (!text.empty()) {
    const CodePoint next = code_point_at_front(text);
    const bool in_font = next.size <= 2 && next.well_formed;  // up to U+07FF: Latin, Greek, Cyrillic
    width += in_font ? kMonospaced : kOther;
    text.remove_prefix(next.size);
  }
  return width * font_size;
}

NodeLabel shown_label(const NodeLabel& label) {
  return {cut(label.title, kLongestLabel), cut(label.subtitle, kLongestLabel)};
}

std::string shown_heading(std::string_view heading) {
  return cut(heading, kLongestHeading);
}

std::vector<TreeBox> layout_tree(const SyntaxTree& tree, NodeId root, const NodeLabeller& label) {
  return TreeLayout(tree, root, label).boxes();
}

}  // namespace texbrdf
