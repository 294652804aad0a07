#pragma once

#include <optional>
#include <span>

#include "ir/graph.h"

namespace texbrdf::ir {

/// A value, and how it changes with a variable; no tangent where it does not.
struct Dual {
  ValueId value;
  std::optional<ValueId> tangent;
};

/// The rules of calculus for operations that bind nothing and call nothing. Writes to a graph.
class DualRules {
 public:
  explicit DualRules(Graph& graph) : graph_(graph) {}

  /// The operation, whose payload and type `value` has, on operands of the graph.
  Dual apply(const Value& value, std::span<const Dual> operands) const;

 private:
  std::optional<ValueId> tangent(const Value& value, ValueId result, std::span<const Dual> operands) const;
  std::optional<ValueId> sum(const std::optional<ValueId>& a, const std::optional<ValueId>& b) const;
  std::optional<ValueId> scaled(ValueId factor, const std::optional<ValueId>& tangent) const;
  std::optional<ValueId> negative(const std::optional<ValueId>& tangent) const;
  std::optional<ValueId> over(const std::optional<ValueId>& tangent, ValueId divisor) const;
  std::optional<ValueId> of_product(Op op, const Dual& a, const Dual& b) const;
  std::optional<ValueId> of_choice(const Value& value, std::span<const Dual> operands) const;
  std::optional<ValueId> of_extremum(const Value& value, std::span<const Dual> operands) const;
  std::optional<ValueId> of_power(ValueId result, const Dual& base, const Dual& exponent) const;
  std::optional<ValueId> of_root(ValueId result, const Dual& radicand, const Dual& index) const;
  std::optional<ValueId> of_arctan2(const Dual& y, const Dual& x) const;
  std::optional<ValueId> of_convention(const Value& value, ValueId result, std::span<const Dual> operands) const;
  std::optional<ValueId> of_vector(std::span<const Dual> operands) const;
  ValueId component(ValueId id, uint32_t index) const;
  ValueId add(Op op, std::initializer_list<ValueId> operands) const { return graph_.add(op, operands); }
  ValueId number(double value) const { return graph_.constant(value); }
  ValueId square(ValueId id) const { return add(Op::Multiply, {id, id}); }

  Graph& graph_;
};

}  // namespace texbrdf::ir
