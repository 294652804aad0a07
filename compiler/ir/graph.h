#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "semantics/conventions.h"
#include "semantics/instance.h"
#include "semantics/types.h"

namespace texbrdf::ir {

/// The typed expression graph of one definition, or of a whole program after `flatten`: pure values, each computed
/// from earlier ones. Ops and their meaning are in ops.def.
enum class Op : uint8_t {
#define OP(name, printed, least, most, payload, meaning) name,
#include "ir/ops.def"
#undef OP
};

enum class Payload : uint8_t { None, Constant, Index };

struct OpEntry {
  Op op;
  std::string_view printed;
  int least_operands;
  int most_operands;  ///< -1: any number
  Payload payload;
};

const OpEntry& op_entry(Op op);

struct ValueId {
  uint32_t value = UINT32_MAX;
  constexpr bool valid() const { return value != UINT32_MAX; }
  friend constexpr auto operator<=>(const ValueId&, const ValueId&) = default;
};

/// Binders (of Sum and Product) that a value depends on, one bit each: nothing is hoisted out of one of its binders.
/// At most 64 binders in a graph.
using BinderSet = uint64_t;
inline constexpr uint32_t kMaxBinders = 64;

/// From here on the index of a Call is a position in Graph::instances, until the graph is linked.
inline constexpr uint32_t kFirstInstance = uint32_t{1} << 31;

struct Value {
  Op op;
  Type type;
  uint32_t index = 0;   ///< payload of kind Index
  double constant = 0;  ///< payload of kind Constant
  uint32_t first_operand = 0;
  uint32_t operand_count = 0;
  BinderSet binders = 0;
};

/// Append-only; operands have smaller ids than their users, so a loop over ids is a bottom-up walk. Adding does not
/// share equal values: that is the pass `share_common_subexpressions`. Operands are not given as a span of the graph
/// that grows.
class Graph {
 public:
  std::span<const Value> values() const { return values_; }
  const Value& at(ValueId id) const { return values_[id.value]; }
  std::span<const ValueId> operands(ValueId id) const {
    const Value& v = at(id);
    return std::span(operands_).subspan(v.first_operand, v.operand_count);
  }
  ValueId operand(ValueId id, uint32_t i) const { return operands_[at(id).first_operand + i]; }
  uint32_t size() const { return static_cast<uint32_t>(values_.size()); }

  /// What the graph is for; kept by every pass, in order. A definition has one.
  std::vector<ValueId> roots;
  /// What calls of functions with other types than they take by themselves are of; none once the graph is linked.
  std::vector<Instance> instances;

  ValueId constant(double number);
  ValueId convention(Convention id, std::span<const ValueId> operands = {});
  /// With what it is made of.
  ValueId whole_convention(Convention id);
  /// Any op with an Index payload or none. The type follows from the operands where the op says so, see `result_type`;
  /// for Reference, Formal, Call, Parameter, BoundVariable and MakeMatrix pass it to `leaf`.
  ValueId add(Op op, std::initializer_list<ValueId> operands, uint32_t index = 0);
  ValueId add(Op op, std::span<const ValueId> operands, uint32_t index = 0);
  /// Reference, Formal, Call, Parameter, BoundVariable, MakeMatrix: their type comes from elsewhere.
  ValueId leaf(Op op, Type type, uint32_t index, std::span<const ValueId> operands = {});
  /// A copy of a value of any graph with operands of this graph.
  ValueId copy(const Value& value, std::span<const ValueId> operands);
  /// An unused binder id.
  uint32_t new_binder();
  uint32_t binder_count() const { return binder_count_; }

 private:
  ValueId append(Value value, std::span<const ValueId> operands);
  std::vector<Value> values_;
  std::vector<ValueId> operands_;
  uint32_t binder_count_ = 0;
};

/// The real as a value of the type: alike in all components. What has components stays what it is.
ValueId add_spread(Graph& graph, ValueId id, Type type);
/// The number as a value of the type, alike in all components.
ValueId add_constant(Graph& graph, double number, Type type);

/// Has a binder of its own, which its last operand may use.
constexpr bool binds(Op op) {
  return op == Op::Sum || op == Op::Product || op == Op::Integral || op == Op::Derivative;
}

/// The type of `op` applied to operands of these types, Type::Error where it does not fit.
Type result_type(Op op, std::span<const Type> operands);

}  // namespace texbrdf::ir
