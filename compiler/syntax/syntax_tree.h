#pragma once

#include <cstdint>
#include <memory_resource>
#include <span>
#include <string_view>
#include <vector>

#include "source/span.h"
#include "syntax/token.h"

namespace texbrdf {

enum class NodeKind : uint8_t {
#define NODE_KIND(name, description) name,
#include "syntax/node_kind.def"
#undef NODE_KIND
};

std::string_view node_kind_name(NodeKind kind);

/// A node of one block's tree. Children come before their parents, so a loop over ids is a bottom-up walk.
struct NodeId {
  uint32_t value = UINT32_MAX;
  constexpr bool valid() const { return value != UINT32_MAX; }
  friend constexpr auto operator<=>(const NodeId&, const NodeId&) = default;
};

struct Node {
  NodeKind kind;
  uint32_t token;        ///< the token that names it: operator, command, `(`, number, first token of a name
  uint32_t first_token;  ///< [first_token, end_token) are all tokens of the node, children included
  uint32_t end_token;
  uint32_t first_child;  ///< into the tree's list of children
  uint32_t child_count;
};

/// The deepest tree: a node may have at most this many levels below it. Deeper input is one error.
inline constexpr uint32_t kMaxTreeHeight = 1000;

/// Lossless: every byte of the block lies in a token or between two (white space, comments and the commands that
/// mean nothing). Holds no names and no types; later stages keep side tables by NodeId.
class SyntaxTree {
 public:
  explicit SyntaxTree(std::pmr::memory_resource* memory) : nodes_(memory), children_(memory) {}

  std::span<const Node> nodes() const { return nodes_; }
  const Node& node(NodeId id) const { return nodes_[id.value]; }
  std::span<const NodeId> children(NodeId id) const {
    const Node& n = node(id);
    return std::span(children_).subspan(n.first_child, n.child_count);
  }
  NodeId child(NodeId id, uint32_t index) const { return children_[node(id).first_child + index]; }
  uint32_t size() const { return static_cast<uint32_t>(nodes_.size()); }

  /// Appends a node; its children must exist already.
  NodeId add(NodeKind kind, uint32_t token, uint32_t first_token, uint32_t end_token,
             std::span<const NodeId> children) {
    nodes_.push_back({kind, token, first_token, end_token, static_cast<uint32_t>(children_.size()),
                      static_cast<uint32_t>(children.size())});
    for (const NodeId child : children) children_.push_back(child);
    return NodeId{static_cast<uint32_t>(nodes_.size() - 1)};
  }
  /// Room for so many nodes that are all but one somebody's child.
  void reserve(uint32_t nodes);
  /// What was read as a call turns out to be the left side of a definition.
  void set_kind(NodeId id, NodeKind kind) { nodes_[id.value].kind = kind; }

 private:
  std::pmr::vector<Node> nodes_;
  std::pmr::vector<NodeId> children_;
};

}  // namespace texbrdf
