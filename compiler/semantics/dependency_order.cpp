#include "semantics/dependency_order.h"

#include <algorithm>

namespace texbrdf {
namespace {

constexpr uint32_t kNone = UINT32_MAX;

/// Tarjan's algorithm with an explicit stack.
class Components {
 public:
  Components(const AdjacencyLists& edges, DependencyOrder& out)
      : edges_(edges), out_(out), number_(edges.size(), kNone), low_(edges.size()), is_pending_(edges.size()) {}

  void run() {
    out_.order.reserve(edges_.size());
    for (uint32_t index = 0; index < edges_.size(); ++index) {
      if (number_[index] == kNone) visit_from(index);
    }
  }

 private:
  struct Visit {
    uint32_t index;
    uint32_t next_edge;
  };

  void enter(uint32_t index) {
    number_[index] = low_[index] = next_number_++;
    is_pending_[index] = true;
    pending_.push_back(index);
    path_.push_back({index, 0});
  }

  void visit_from(uint32_t first) {
    enter(first);
    while (!path_.empty()) {
      Visit& visit = path_.back();
      const std::span<const uint32_t> targets = edges_.of(visit.index);
      if (visit.next_edge < targets.size()) {
        follow(visit.index, targets[visit.next_edge++]);
      } else {
        leave(visit.index);
      }
    }
  }

  void follow(uint32_t from, uint32_t to) {
    if (number_[to] == kNone) {
      enter(to);
    } else if (is_pending_[to]) {
      low_[from] = std::min(low_[from], number_[to]);
    }
  }

  void leave(uint32_t index) {
    path_.pop_back();
    if (!path_.empty()) low_[path_.back().index] = std::min(low_[path_.back().index], low_[index]);
    if (low_[index] == number_[index]) close_component(index);
  }

  void close_component(uint32_t root) {
    if (pending_.back() == root && !mentions_itself(root)) {
      is_pending_[root] = false;
      pending_.pop_back();
      out_.order.push_back(root);
      return;
    }
    auto first = pending_.end();
    do {
      --first;
      is_pending_[*first] = false;
    } while (*first != root);
    const std::vector<uint32_t> members(first, pending_.end());
    pending_.erase(first, pending_.end());
    out_.order.insert(out_.order.end(), members.rbegin(), members.rend());
    out_.knots.push_back(members);
  }

  bool mentions_itself(uint32_t index) const {
    return std::ranges::find(edges_.of(index), index) != edges_.of(index).end();
  }

  const AdjacencyLists& edges_;
  DependencyOrder& out_;
  std::vector<uint32_t> number_, low_;
  std::vector<bool> is_pending_;
  std::vector<uint32_t> pending_;
  std::vector<Visit> path_;
  uint32_t next_number_ = 0;
};

/// The shortest way from the smallest member of a knot back to itself. `came_from` is all kNone before and after.
std::vector<uint32_t> shortest_cycle(const AdjacencyLists& edges, const std::vector<uint32_t>& knot,
                                     const std::vector<uint32_t>& knot_of, std::vector<uint32_t>& came_from) {
  const uint32_t start = *std::ranges::min_element(knot);
  std::vector<uint32_t> queue = {start};
  std::vector<uint32_t> cycle;
  for (size_t next = 0; next < queue.size() && cycle.empty(); ++next) {
    for (uint32_t target : edges.of(queue[next])) {
      if (target == start) {
        for (uint32_t at = queue[next]; at != start; at = came_from[at]) cycle.push_back(at);
        cycle.push_back(start);
        break;
      }
      if (knot_of[target] != knot_of[start] || came_from[target] != kNone) continue;
      came_from[target] = queue[next];
      queue.push_back(target);
    }
  }
  for (uint32_t index : queue) came_from[index] = kNone;
  std::ranges::reverse(cycle);
  return cycle;
}

}  // namespace

DependencyOrder dependency_order(const AdjacencyLists& edges) {
  DependencyOrder result;
  Components(edges, result).run();
  if (result.knots.empty()) return result;

  std::vector<uint32_t> knot_of(edges.size(), kNone);
  for (uint32_t knot = 0; knot < result.knots.size(); ++knot) {
    for (uint32_t member : result.knots[knot]) knot_of[member] = knot;
  }
  std::vector<uint32_t> came_from(edges.size(), kNone);
  for (const std::vector<uint32_t>& knot : result.knots) {
    result.cycles.push_back(shortest_cycle(edges, knot, knot_of, came_from));
  }
  return result;
}

}  // namespace texbrdf
