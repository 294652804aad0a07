#include "ir/quadrature.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "ir/passes/rewrite.h"

namespace texbrdf::ir {
namespace {

constexpr std::size_t kPoints = 8;

/// The rule on [-1, 1] is symmetric: the places and weights of its right half.
struct Point {
  double place;
  double weight;
};
constexpr std::array<Point, kPoints / 2> kRightHalf = {{
    {0.1834346424956498, 0.3626837833783620},
    {0.5255324099163290, 0.3137066458778873},
    {0.7966664774136267, 0.2223810344533745},
    {0.9602898564975363, 0.1012285362903763},
}};

/// Of an integral by itself, of those two of which one lies in the other …
constexpr std::array<uint32_t, 4> kPanels = {16, 6, 2, 2};

class Expansion {
 public:
  Expansion(const Graph& source, Fineness fineness) : source_(source), fineness_(fineness), panels_(kMaxBinders) {}

  std::optional<Graph> run() {
    count_panels();
    next_binder_ = source_.binder_count();
    Graph result = rewrite(source_, [this](Graph& graph, ValueId id, std::span<const ValueId> operands) {
      const Value& value = source_.at(id);
      const bool is_of_integral = value.op == Op::BoundVariable && panels_[value.index] > 0;
      if (is_of_integral) return place(graph, value.index);
      return value.op == Op::Integral ? sum(graph, value.index, operands[0]) : graph.copy(value, operands);
    });
    return next_binder_ <= kMaxBinders ? std::optional(std::move(result)) : std::nullopt;
  }

 private:
  /// The deeper integrals nest, the fewer panels has each.
  void count_panels() {
    std::vector<uint32_t> height(source_.size());
    BinderSet integrals = 0;
    for (uint32_t i = 0; i < source_.size(); ++i) {
      for (const ValueId operand : source_.operands({i})) height[i] = std::max(height[i], height[operand.value]);
      if (source_.at({i}).op != Op::Integral) continue;
      ++height[i];
      integrals |= BinderSet{1} << source_.at({i}).index;
    }
    for (uint32_t i = 0; i < source_.size(); ++i) {
      const Value& value = source_.at({i});
      if (value.op != Op::Integral) continue;
      const std::size_t level = height[i] + static_cast<std::size_t>(std::popcount(value.binders & integrals));
      panels_[value.index] = kPanels[std::min(level, kPanels.size()) - 1];
      if (fineness_ == Fineness::Half) panels_[value.index] /= 2;
    }
  }

  /// What depends on which point it is: the first number left of all, and so on.
  template <typename Number>
  ValueId choose(Graph& graph, ValueId point, Number number) const {
    ValueId chosen = graph.constant(number(kPoints - 1));
    for (std::size_t i = kPoints - 1; i-- > 0;) {
      const ValueId is_here = graph.add(Op::Less, {point, graph.constant(static_cast<double>(i) + 0.5)});
      chosen = graph.add(Op::Select, {is_here, graph.constant(number(i)), chosen});
    }
    return chosen;
  }

  static const Point& point(std::size_t i) {
    return i < kPoints / 2 ? kRightHalf[kPoints / 2 - 1 - i] : kRightHalf[i - kPoints / 2];
  }

  /// The integral's variable, in [0, 1].
  ValueId place(Graph& graph, uint32_t binder) {
    if (points_.empty()) points_.resize(kMaxBinders, kMaxBinders);
    if (points_[binder] == kMaxBinders) points_[binder] = std::min(next_binder_++, kMaxBinders - 1);
    const ValueId panel = graph.leaf(Op::BoundVariable, Type::Real, binder);
    const ValueId index = graph.leaf(Op::BoundVariable, Type::Real, points_[binder]);
    const ValueId inside =
        choose(graph, index, [](std::size_t i) { return 0.5 + (i < kPoints / 2 ? -0.5 : 0.5) * point(i).place; });
    return graph.add(Op::Divide, {graph.add(Op::Add, {panel, inside}), graph.constant(panels_[binder])});
  }

  ValueId sum(Graph& graph, uint32_t binder, ValueId body) {
    if (points_.empty() || points_[binder] == kMaxBinders) return body;  // which does not depend on the variable
    const ValueId index = graph.leaf(Op::BoundVariable, Type::Real, points_[binder]);
    const double panels = panels_[binder];
    const ValueId weight = choose(graph, index, [panels](std::size_t i) { return point(i).weight / (2 * panels); });
    const ValueId term = graph.add(Op::Multiply, {weight, body});
    const ValueId zero = graph.constant(0);
    const ValueId of_panel = graph.add(Op::Sum, {zero, graph.constant(kPoints - 1), term}, points_[binder]);
    return graph.add(Op::Sum, {zero, graph.constant(panels - 1), of_panel}, binder);
  }

  const Graph& source_;
  const Fineness fineness_;
  std::vector<uint32_t> panels_;  // by binder
  std::vector<uint32_t> points_;  // by binder of an integral: the one of the points
  uint32_t next_binder_ = 0;
};

}  // namespace

std::optional<Graph> expand_integrals(const Graph& graph, Fineness fineness) {
  const bool holds_some =
      std::ranges::any_of(graph.values(), [](const Value& value) { return value.op == Op::Integral; });
  return holds_some ? Expansion(graph, fineness).run() : std::optional(graph);
}

}  // namespace texbrdf::ir
