#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "syntax/parsed_block.h"

namespace texbrdf {

/// A sum, product, integral or derivative: it binds a name in what it is taken of.
struct Binder {
  NodeId node;
  NodeId variable;           ///< the Name that it binds
  NodeId range;              ///< Range, Set or Domain; invalid for a derivative
  NodeId body;               ///< where the name is bound
  uint32_t first_node = 0;   ///< of the body's tree, which ends with `body`
  std::vector<int> indices;  ///< the numbers that names with the index are looked up for, in order
  bool is_open = false;      ///< only the document tells the last index; `indices` are the first ones
  bool is_over_directions = false;
};

/// In order of nodes: inner ones before outer ones.
std::vector<Binder> find_binders(const ParsedBlock& block);

/// Which binders a node stands in, while one goes through the nodes in order.
class OpenBinders {
 public:
  explicit OpenBinders(std::span<const Binder> binders);
  void advance_to(uint32_t node);
  /// Positions among the binders, outermost first.
  std::span<const uint32_t> open() const { return open_; }

 private:
  std::span<const Binder> binders_;
  std::vector<uint32_t> by_begin_;
  size_t next_ = 0;
  std::vector<uint32_t> open_;
};

/// More in each other are an error.
inline constexpr size_t kMostNestedBinders = 8;

/// What an integral without bounds is taken over.
enum class Directions : uint8_t { Hemisphere, Sphere };
std::optional<Directions> directions_of(const ParsedBlock& block, NodeId domain);

}  // namespace texbrdf
