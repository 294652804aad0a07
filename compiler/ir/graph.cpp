#include "ir/graph.h"

#include <algorithm>
#include <array>
#include <vector>

#include "source/internal_error.h"

namespace texbrdf::ir {

ValueId Graph::constant(double number) {
  return append({.op = Op::Constant, .type = Type::Real, .constant = number}, {});
}

ValueId Graph::convention(Convention id, std::span<const ValueId> operands) {
  const ConventionEntry& entry = convention_entry(id);
  require(operands.empty() || operands.size() == entry.operands.size(), "convention with a wrong number of operands");
  return append({.op = Op::Convention, .type = entry.type, .index = static_cast<uint32_t>(id)}, operands);
}

/// At most three levels deep: \theta_h is made of \vec{h}, which is made of the two directions.
ValueId Graph::whole_convention(Convention id) {
  std::vector<ValueId> operands;
  for (const Convention operand : convention_entry(id).operands) operands.push_back(whole_convention(operand));
  return convention(id, operands);
}

ValueId Graph::add(Op op, std::initializer_list<ValueId> operands, uint32_t index) {
  return add(op, std::span(operands.begin(), operands.size()), index);
}

ValueId Graph::add(Op op, std::span<const ValueId> operands, uint32_t index) {
  require(operands.size() <= 3, "more operands than any op has whose type follows from them");
  std::array<Type, 3> types{};
  std::transform(operands.begin(), operands.end(), types.begin(), [this](ValueId id) { return at(id).type; });
  const Type type = result_type(op, std::span(types).first(operands.size()));
  require(type != Type::Error, "operands that do not fit their op");
  return append({.op = op, .type = type, .index = index}, operands);
}

ValueId Graph::leaf(Op op, Type type, uint32_t index, std::span<const ValueId> operands) {
  return append({.op = op, .type = type, .index = index}, operands);
}

ValueId Graph::copy(const Value& value, std::span<const ValueId> operands) {
  return append({.op = value.op, .type = value.type, .index = value.index, .constant = value.constant}, operands);
}

uint32_t Graph::new_binder() {
  require(binder_count_ < kMaxBinders, "more binders than a graph may have");
  return binder_count_++;
}

ValueId add_spread(Graph& graph, ValueId id, Type type) {
  if (graph.at(id).type != Type::Real || type == Type::Real) return id;
  if (is_aggregate(type)) return graph.leaf(Op::MakeMatrix, type, 0, std::vector(type_components(type), id));
  return is_triple(type) ? graph.add(Op::MakeVector, {id, id, id}) : id;
}

ValueId add_constant(Graph& graph, double number, Type type) {
  return add_spread(graph, graph.constant(number), type);
}

namespace {

BinderSet binder_bit(uint32_t binder) {
  require(binder < kMaxBinders, "a binder id out of range");
  return BinderSet{1} << binder;
}

}  // namespace

ValueId Graph::append(Value value, std::span<const ValueId> operands) {
  value.first_operand = static_cast<uint32_t>(operands_.size());
  value.operand_count = static_cast<uint32_t>(operands.size());
  value.binders = 0;
  for (const ValueId operand : operands) {
    if (operand.value < values_.size()) value.binders |= at(operand).binders;
  }
  const bool reduces = binds(value.op);
  if (reduces) value.binders &= ~binder_bit(value.index);
  if (value.op == Op::BoundVariable) value.binders = binder_bit(value.index);
  if (reduces || value.op == Op::BoundVariable) binder_count_ = std::max(binder_count_, value.index + 1);
  operands_.insert(operands_.end(), operands.begin(), operands.end());
  values_.push_back(value);
  return {static_cast<uint32_t>(values_.size() - 1)};
}

}  // namespace texbrdf::ir
