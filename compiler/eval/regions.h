#pragma once

#include <cstdint>
#include <vector>

#include "ir/graph.h"

namespace texbrdf::eval {

using RegionId = uint32_t;
inline constexpr RegionId kNoRegion = UINT32_MAX;
inline constexpr RegionId kRootRegion = 0;

/// The tree of regions: the root, branches of a Select, bodies of a Sum or Product. Regions are only added.
class RegionTree {
 public:
  RegionTree();
  RegionId add_branch(RegionId parent);
  RegionId add_loop(RegionId parent, uint32_t binder);

  RegionId parent(RegionId region) const { return nodes_[region].parent; }
  /// The innermost region that holds both.
  RegionId common_ancestor(RegionId a, RegionId b) const;
  /// `region`, or the region around the outermost of the loops that can be left by a value with these binders.
  RegionId outside_of_loops(RegionId region, ir::BinderSet binders) const;
  /// The binders of all loops around `region`.
  ir::BinderSet binders(RegionId region) const { return nodes_[region].binders; }
  uint32_t size() const { return static_cast<uint32_t>(nodes_.size()); }

 private:
  struct Node {
    RegionId parent;
    RegionId jump;  ///< an ancestor farther up, chosen so that any ancestor is reached in O(log depth) steps
    RegionId loop;  ///< the innermost loop around, itself included; kNoRegion without one
    uint32_t depth;
    ir::BinderSet binders;
    ir::BinderSet own_binder;
  };
  RegionId add(RegionId parent);
  RegionId ancestor_at_depth(RegionId region, uint32_t depth) const;

  std::vector<Node> nodes_;
};

}  // namespace texbrdf::eval
