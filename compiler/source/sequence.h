#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "source/shared_pool.h"

namespace texbrdf {

/// An immutable list with sums over its items, kept as a weight-balanced tree (Adams, 1993; balance as in Hirai and
/// Yamamoto, 2011). Changing a few items of n costs O(log n) time and memory; what did not change is shared. Copies are
/// cheap and may be read by any thread.
///
/// `Item::Measure` is the sum: its default value is the sum of nothing, `a + b` the sum of two stretches one after the
/// other, and `item.measure()` that of one item. Sums that are searched for must grow along the list.
template <typename Item>
class Sequence {
  struct Node;

 public:
  using Measure = typename Item::Measure;

  /// An item, how many stand before it and their sum. `item` is nullptr behind the end.
  struct Place {
    const Item* item = nullptr;
    uint32_t index = 0;
    Measure before;
  };

  /// Lists of one item that are expected to go about together.
  using Pool = SharedPool<Node>;

  Sequence() = default;
  Sequence(Item item, Pool& pool) : root_(pool.make(node_of(nullptr, std::move(item), nullptr))) {}
  explicit Sequence(std::span<const Item> items) : root_(build(items)) {}
  explicit Sequence(std::vector<Item> items) : root_(build(std::span(items))) {}

  uint32_t size() const { return size_of(root_); }
  bool empty() const { return root_ == nullptr; }
  Measure measure() const { return measure_of(root_); }

  /// The first item with which the sum, from the beginning of the list to its own end, satisfies `reached`.
  template <typename Predicate>
  Place find(const Predicate& reached) const {
    Place place;
    const Node* node = root_.get();
    while (node != nullptr) {
      const Measure left = place.before + measure_of(node->left);
      if (node->left && reached(left)) {
        node = node->left.get();
        continue;
      }
      place.index += size_of(node->left);
      place.before = left;
      const Measure with_item = left + node->item.measure();
      if (reached(with_item)) {
        place.item = &node->item;
        return place;
      }
      ++place.index;
      place.before = with_item;
      node = node->right.get();
    }
    return place;
  }

  /// Of an item that exists.
  Place at(uint32_t index) const {
    Measure before;
    const Node* node = root_.get();
    for (uint32_t wanted = index;;) {
      const uint32_t left = size_of(node->left);
      if (wanted < left) {
        node = node->left.get();
        continue;
      }
      before = before + measure_of(node->left);
      if (wanted == left) return {&node->item, index, before};
      before = before + node->item.measure();
      wanted -= left + 1;
      node = node->right.get();
    }
  }

  /// Visits the items from `first` on, with the sum of all before each, until `visit(item, before)` gives false.
  template <typename Visit>
  void visit_from(uint32_t first, const Visit& visit) const {
    Measure before;
    visit_node(root_.get(), first, before, visit);
  }

  /// Visits the items of the stretches for whose sum `matters(sum)` holds, until `visit(item, before)` gives false.
  template <typename Matters, typename Visit>
  void visit_where(const Matters& matters, const Visit& visit) const {
    visit_matching(root_.get(), Measure{}, matters, visit);
  }

  /// Changes every item in place. Precondition: neither this list nor one that it was made from has been copied.
  template <typename Change>
  void change_all(const Change& change) {
    change_node(root_, change);
  }

  /// The list with `items` in the place of `count` items from `first` on.
  Sequence with(uint32_t first, uint32_t count, std::span<const Item> items) const {
    if (empty()) return Sequence(items);
    if (count == 1 && items.size() == 1) return Sequence(with_item(root_, first, items.front()));
    auto [before, rest] = split(root_, first);
    auto [removed, behind] = split(rest, count);
    return Sequence(join(join(before, build(items)), behind));
  }

 private:
  using Link = std::shared_ptr<Node>;
  struct Node {
    Link left, right;
    Item item;
    uint32_t size;
    Measure measure;
  };

  // Weights differ at most by kDelta; a single rotation is enough where the inner child is lighter than kRatio times
  // the outer one.
  static constexpr uint32_t kDelta = 3;
  static constexpr uint32_t kRatio = 2;

  explicit Sequence(Link root) : root_(std::move(root)) {}

  static uint32_t size_of(const Link& node) { return node ? node->size : 0; }
  static uint32_t weight(const Link& node) { return size_of(node) + 1; }
  static Measure measure_of(const Link& node) { return node ? node->measure : Measure{}; }

  static Node node_of(Link left, Item item, Link right) {
    const uint32_t size = size_of(left) + size_of(right) + 1;
    const Measure measure = measure_of(left) + item.measure() + measure_of(right);
    return {std::move(left), std::move(right), std::move(item), size, measure};
  }
  static Link make(Link left, Item item, Link right) {
    return std::make_shared<Node>(node_of(std::move(left), std::move(item), std::move(right)));
  }

  /// Moves the items unless they are const.
  template <typename SomeItem>
  static Link build(std::span<SomeItem> items) {
    if (items.size() == 1) return make(nullptr, std::move(items.front()), nullptr);
    std::vector<Pool> pools;  // by depth: no two nodes of one allocation may own each other
    for (size_t size = items.size(); size > 0; size /= 2) pools.emplace_back(size_t{1} << pools.size());
    return build(items, pools.data());
  }
  template <typename SomeItem>
  static Link build(std::span<SomeItem> items, Pool* pool) {
    if (items.empty()) return nullptr;
    const size_t middle = items.size() / 2;
    Link left = build(items.first(middle), pool + 1);
    Link right = build(items.subspan(middle + 1), pool + 1);
    return pool->make(node_of(std::move(left), std::move(items[middle]), std::move(right)));
  }

  static Link rotate_left(const Link& left, const Item& item, const Link& right) {
    if (weight(right->left) < kRatio * weight(right->right)) {
      return make(make(left, item, right->left), right->item, right->right);
    }
    const Node& inner = *right->left;
    return make(make(left, item, inner.left), inner.item, make(inner.right, right->item, right->right));
  }
  static Link rotate_right(const Link& left, const Item& item, const Link& right) {
    if (weight(left->right) < kRatio * weight(left->left)) {
      return make(left->left, left->item, make(left->right, item, right));
    }
    const Node& inner = *left->right;
    return make(make(left->left, left->item, inner.left), inner.item, make(inner.right, item, right));
  }
  /// Precondition: one side grew or shrank by one since the weights were right.
  static Link balance(const Link& left, const Item& item, const Link& right) {
    if (weight(right) > kDelta * weight(left)) return rotate_left(left, item, right);
    if (weight(left) > kDelta * weight(right)) return rotate_right(left, item, right);
    return make(left, item, right);
  }

  static Link join(const Link& left, const Item& item, const Link& right) {
    if (weight(right) > kDelta * weight(left)) {
      return balance(join(left, item, right->left), right->item, right->right);
    }
    if (weight(left) > kDelta * weight(right)) {
      return balance(left->left, left->item, join(left->right, item, right));
    }
    return make(left, item, right);
  }

  static std::pair<Item, Link> without_first(const Link& node) {
    if (!node->left) return {node->item, node->right};
    auto [first, rest] = without_first(node->left);
    return {std::move(first), balance(rest, node->item, node->right)};
  }
  static Link join(const Link& left, const Link& right) {
    if (!left) return right;
    if (!right) return left;
    auto [first, rest] = without_first(right);
    return join(left, first, rest);
  }

  static std::pair<Link, Link> split(const Link& node, uint32_t index) {
    if (!node) return {};
    const uint32_t left = size_of(node->left);
    if (index <= left) {
      auto [before, behind] = split(node->left, index);
      return {before, join(behind, node->item, node->right)};
    }
    auto [before, behind] = split(node->right, index - left - 1);
    return {join(node->left, node->item, before), behind};
  }

  static Link with_item(const Link& node, uint32_t index, const Item& item) {
    const uint32_t left = size_of(node->left);
    if (index < left) return make(with_item(node->left, index, item), node->item, node->right);
    if (index > left) return make(node->left, node->item, with_item(node->right, index - left - 1, item));
    return make(node->left, item, node->right);
  }

  template <typename Change>
  static void change_node(const Link& node, const Change& change) {
    if (!node) return;
    change_node(node->left, change);
    change(node->item);
    change_node(node->right, change);
    node->measure = measure_of(node->left) + node->item.measure() + measure_of(node->right);
  }

  template <typename Visit>
  static bool visit_node(const Node* node, uint32_t first, Measure& before, const Visit& visit) {
    if (first == 0) return visit_all(node, before, visit);
    if (node == nullptr) return true;
    const uint32_t left = size_of(node->left);
    if (first >= left) {
      before = before + measure_of(node->left);
    } else if (!visit_node(node->left.get(), first, before, visit)) {
      return false;
    }
    if (first <= left && !visit(node->item, std::as_const(before))) return false;
    before = before + node->item.measure();
    return visit_node(node->right.get(), first <= left ? 0 : first - left - 1, before, visit);
  }
  /// Reads no sums but those of items: a node is touched once.
  template <typename Visit>
  static bool visit_all(const Node* node, Measure& before, const Visit& visit) {
    if (node == nullptr) return true;
    if (!visit_all(node->left.get(), before, visit) || !visit(node->item, std::as_const(before))) return false;
    before = before + node->item.measure();
    return visit_all(node->right.get(), before, visit);
  }

  template <typename Matters, typename Visit>
  static bool visit_matching(const Node* node, const Measure& before, const Matters& matters, const Visit& visit) {
    if (node == nullptr || !matters(node->measure)) return true;
    if (!visit_matching(node->left.get(), before, matters, visit)) return false;
    const Measure here = before + measure_of(node->left);
    if (matters(node->item.measure()) && !visit(node->item, here)) return false;
    return visit_matching(node->right.get(), here + node->item.measure(), matters, visit);
  }

  Link root_;
};

}  // namespace texbrdf
