#include "eval/regions.h"

#include <utility>

#include "source/internal_error.h"

namespace texbrdf::eval {

RegionTree::RegionTree() {
  nodes_.push_back(
      {.parent = kRootRegion, .jump = kRootRegion, .loop = kNoRegion, .depth = 0, .binders = 0, .own_binder = 0});
}

RegionId RegionTree::add_branch(RegionId parent) {
  return add(parent);
}

RegionId RegionTree::add_loop(RegionId parent, uint32_t binder) {
  const RegionId region = add(parent);
  Node& node = nodes_[region];
  node.loop = region;
  node.own_binder = ir::BinderSet{1} << binder;
  require((node.binders & node.own_binder) == 0, "a reduction inside one of the same binder");
  node.binders |= node.own_binder;
  return region;
}

/// Jump pointers as in "Applications of path compression" (Myers 1983): a node's jump is as long as the two jumps of
/// its parent together, where those are of equal length.
RegionId RegionTree::add(RegionId parent) {
  const Node& above = nodes_[parent];
  const Node& skipped = nodes_[above.jump];
  const bool equal_jumps = above.depth - skipped.depth == skipped.depth - nodes_[skipped.jump].depth;
  const Node node{.parent = parent,
                  .jump = equal_jumps ? skipped.jump : parent,
                  .loop = above.loop,
                  .depth = above.depth + 1,
                  .binders = above.binders,
                  .own_binder = 0};
  nodes_.push_back(node);
  return size() - 1;
}

RegionId RegionTree::ancestor_at_depth(RegionId region, uint32_t depth) const {
  while (nodes_[region].depth > depth) {
    const Node& node = nodes_[region];
    region = nodes_[node.jump].depth >= depth ? node.jump : node.parent;
  }
  return region;
}

RegionId RegionTree::common_ancestor(RegionId a, RegionId b) const {
  if (nodes_[a].depth < nodes_[b].depth) std::swap(a, b);
  a = ancestor_at_depth(a, nodes_[b].depth);
  while (a != b) {
    const bool jump = nodes_[a].jump != nodes_[b].jump;
    a = jump ? nodes_[a].jump : nodes_[a].parent;
    b = jump ? nodes_[b].jump : nodes_[b].parent;
  }
  return a;
}

RegionId RegionTree::outside_of_loops(RegionId region, ir::BinderSet binders) const {
  for (RegionId loop = nodes_[region].loop; loop != kNoRegion; loop = nodes_[region].loop) {
    if ((nodes_[loop].own_binder & binders) != 0) break;
    region = nodes_[loop].parent;
  }
  return region;
}

}  // namespace texbrdf::eval
