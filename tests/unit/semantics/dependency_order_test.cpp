#include "semantics/dependency_order.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace texbrdf {
namespace {

AdjacencyLists lists(const std::vector<std::vector<uint32_t>>& edges) {
  AdjacencyLists result;
  for (const auto& targets : edges) {
    result.targets.insert(result.targets.end(), targets.begin(), targets.end());
    result.close_list();
  }
  return result;
}

using Cycles = std::vector<std::vector<uint32_t>>;

TEST(DependencyOrder, PutsWhatIsMentionedFirst) {
  const std::vector<std::vector<uint32_t>> edges = {{2, 1}, {3}, {3, 1}, {}};
  const DependencyOrder order = dependency_order(lists(edges));
  ASSERT_EQ(order.order.size(), edges.size());
  const auto place = [&](uint32_t index) { return std::ranges::find(order.order, index) - order.order.begin(); };
  for (uint32_t from = 0; from < edges.size(); ++from) {
    for (uint32_t to : edges[from]) EXPECT_LT(place(to), place(from));
  }
  EXPECT_TRUE(order.cycles.empty());
}

TEST(DependencyOrder, NamesRealCyclesFromTheSmallestIndex) {
  EXPECT_EQ(dependency_order(lists({{0}})).cycles, (Cycles{{0}}));
  EXPECT_EQ(dependency_order(lists({{1}, {0}})).cycles, (Cycles{{0, 1}}));
  EXPECT_EQ(dependency_order(lists({{}, {3}, {1}, {2}})).cycles, (Cycles{{1, 3, 2}}));
}

TEST(DependencyOrder, TellsOneShortestCycleOfAKnot) {
  // 0 → 1 → 2 → 0 and 0 → 3 → 0; 4 only mentions them.
  const DependencyOrder order = dependency_order(lists({{1, 3}, {2}, {0}, {0}, {0}}));
  EXPECT_EQ(order.cycles, (Cycles{{0, 3}}));
  ASSERT_EQ(order.knots.size(), 1u);
  EXPECT_EQ(order.knots[0].size(), 4u);
  EXPECT_EQ(order.order.back(), 4u);
}

TEST(DependencyOrder, SeparateCyclesAreTold) {
  EXPECT_EQ(dependency_order(lists({{1}, {0}, {3}, {2}, {0, 2}})).cycles.size(), 2u);
}

TEST(DependencyOrder, WalksLongChainsAndCycles) {
  const uint32_t length = 200'000;
  std::vector<std::vector<uint32_t>> edges(length);
  for (uint32_t i = 0; i + 1 < length; ++i) edges[i] = {i + 1};
  EXPECT_EQ(dependency_order(lists(edges)).order.front(), length - 1);
  edges.back() = {0};
  const DependencyOrder order = dependency_order(lists(edges));
  ASSERT_EQ(order.cycles.size(), 1u);
  EXPECT_EQ(order.cycles[0].size(), length);
}

}  // namespace
}  // namespace texbrdf
