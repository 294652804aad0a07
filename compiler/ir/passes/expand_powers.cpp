#include <cmath>
#include <optional>

#include "ir/passes/passes.h"
#include "ir/passes/rewrite.h"

namespace texbrdf::ir {

namespace {

/// The largest exponent that becomes a product: three multiplications.
constexpr double kLargestExponent = 8;

/// Values that are never −0, which is where products and roots differ from powers: the power of a zero of either sign
/// is +0, or +∞ where the exponent is negative.
class NeverNegativeZero {
 public:
  /// `id` is the next value of `graph`, and all before it are noted.
  void note(const Graph& graph, ValueId id) { known_.push_back(find(graph, id)); }
  bool operator()(ValueId id) const { return known_[id.value]; }

 private:
  bool find(const Graph& graph, ValueId id) const {
    const Value& value = graph.at(id);
    const auto operands = graph.operands(id);
    const auto holds = [&](std::size_t i) { return known_[operands[i].value]; };
    const Op op = value.op;
    if (value.type != Type::Real) return false;
    if (op == Op::Constant) return value.constant != 0 || !std::signbit(value.constant);
    if (op == Op::Add) return holds(0) || holds(1);  // −0 only where both operands are
    if (op == Op::Subtract || op == Op::Sqrt) return holds(0);
    if (op == Op::Min || op == Op::Max) return holds(0) && holds(1);
    if (op == Op::Select) return holds(1) && holds(2);
    if (op == Op::Multiply || op == Op::Dot) return operands[0] == operands[1];
    return op == Op::Exp || op == Op::Cosh || op == Op::Cos || op == Op::Arccos;
  }

  std::vector<bool> known_;
};

class PowerExpander {
 public:
  explicit PowerExpander(const Graph& source) : source_(source) {}

  Graph run() {
    return rewrite(source_, [this](Graph& graph, ValueId id, std::span<const ValueId> operands) {
      return convert(graph, source_.at(id), operands);
    });
  }

 private:
  ValueId convert(Graph& graph, const Value& value, std::span<const ValueId> operands) {
    note_up_to_now(graph);
    const bool candidate = value.op == Op::Power || value.op == Op::Root;
    if (candidate && graph.at(operands[1]).op == Op::Constant) {
      const double number = graph.at(operands[1]).constant;
      const auto simpler = value.op == Op::Power ? power(graph, operands[0], number) : root(graph, operands[0], number);
      if (simpler) return *simpler;
    }
    return graph.copy(value, operands);
  }

  void note_up_to_now(const Graph& graph) {
    while (noted_ < graph.size()) never_negative_zero_.note(graph, {noted_++});
  }

  std::optional<ValueId> power(Graph& graph, ValueId base, double exponent) const {
    const double magnitude = std::abs(exponent);
    if (magnitude == 0.5) return square_root(graph, base, exponent < 0);
    if (std::trunc(exponent) != exponent || magnitude > kLargestExponent) return std::nullopt;
    const auto count = static_cast<uint32_t>(magnitude);
    if (exponent >= 0) return product(graph, base, count);
    // 1/(−0)ⁿ is −∞ for odd n, the power +∞.
    if (count % 2 != 0 && !never_negative_zero_(base)) return std::nullopt;
    return graph.add(Op::Divide, {graph.constant(1), product(graph, base, count)});
  }

  /// x^0.5 is √x but for −0: its power is +0, its root −0.
  std::optional<ValueId> square_root(Graph& graph, ValueId base, bool reciprocal) const {
    if (!never_negative_zero_(base)) return std::nullopt;
    const ValueId result = graph.add(Op::Sqrt, {base});
    return reciprocal ? graph.add(Op::Divide, {graph.constant(1), result}) : result;
  }

  std::optional<ValueId> root(Graph& graph, ValueId radicand, double index) const {
    return index == 2 ? square_root(graph, radicand, false) : std::nullopt;
  }

  static ValueId one_like(Graph& graph, ValueId base) { return add_constant(graph, 1, graph.at(base).type); }

  /// By squaring, from the highest bit of the exponent down: x⁵ is (x²)²·x.
  static ValueId product(Graph& graph, ValueId base, uint32_t count) {
    if (count == 0) return one_like(graph, base);
    ValueId result = base;
    uint32_t bit = 1;
    while (bit * 2 <= count) bit *= 2;
    while ((bit /= 2) != 0) {
      result = graph.add(Op::Multiply, {result, result});
      if ((count & bit) != 0) result = graph.add(Op::Multiply, {result, base});
    }
    return result;
  }

  const Graph& source_;
  NeverNegativeZero never_negative_zero_;
  uint32_t noted_ = 0;
};

}  // namespace

Graph expand_powers(const Graph& graph) {
  return PowerExpander(graph).run();
}

}  // namespace texbrdf::ir
