#include <algorithm>
#include <vector>

#include "ir/lower_builtin.h"
#include "ir/lowering.h"
#include "source/internal_error.h"

namespace texbrdf::ir {

ValueId Lowering::builtin(NodeId node, Builtin function) {
  if (is_of_matrices(node)) return matrix_builtin(node, function);
  std::vector<ValueId> arguments;
  for (const NodeId child : block_.tree.children(node).subspan(1)) arguments.push_back(value(child));
  return lower_builtin(graph_, function, arguments);
}

ValueId Lowering::call(NodeId node) {
  const NodeId name = block_.tree.child(node, 0);
  const Referent& callee = referent(name);
  if (callee.kind == Referent::Kind::Builtin) return builtin(node, static_cast<Builtin>(callee.index));
  if (callee.kind == Referent::Kind::Derivative) return derivative_call(node);
  const std::span<const NodeId> arguments = block_.tree.children(node).subspan(1);
  std::vector<ValueId> values;
  uint64_t spread = 0;
  for (size_t i = 0; i < arguments.size(); ++i) {
    values.push_back(value(arguments[i]));
    if (is_spread(arguments[i])) spread |= uint64_t{1} << i;
  }
  if (callee.kind == Referent::Kind::Indexed) {
    return call_of(name_at(checked_.indexed[callee.index]).value, type(name), values, spread);
  }
  require(callee.kind == Referent::Kind::Definition, "a call of what is no definition in a sound definition");
  return call_of(instance_index(name).value_or(callee.index), type(name), values, spread);
}

std::optional<uint32_t> Lowering::instance_index(NodeId callee) const {
  const std::vector<InstanceCall>& calls = checked_.instance_calls;
  const auto found = std::ranges::lower_bound(calls, callee, {}, &InstanceCall::callee);
  if (found == calls.end() || found->callee != callee) return std::nullopt;
  return kFirstInstance + static_cast<uint32_t>(found - calls.begin());
}

ValueId Lowering::implied_call(const ImpliedCall& call) {
  std::vector<ValueId> arguments;
  for (const TypedReferent& argument : call.arguments) arguments.push_back(value_of(argument));
  return call_of(referent(call.node).index, call.result, arguments, call.spread);
}

/// Colours for real parameters (`spread`, by position) make it a call for each component.
ValueId Lowering::call_of(uint32_t callee, Type result, std::span<const ValueId> arguments, uint64_t spread) {
  if (spread == 0) return graph_.leaf(Op::Call, result, callee, with_entries(arguments));
  const auto of_component = [&](uint32_t component) {
    std::vector<ValueId> parts(arguments.begin(), arguments.end());
    for (size_t i = 0; i < parts.size() && i < 64; ++i) {
      if (((spread >> i) & 1) != 0) parts[i] = graph_.add(Op::Component, {arguments[i]}, component);
    }
    const ValueId part = graph_.leaf(Op::Call, result, callee, with_entries(parts));
    return is_triple(result) ? graph_.add(Op::Component, {part}, component) : part;
  };
  return graph_.add(Op::MakeVector, {of_component(0), of_component(1), of_component(2)});
}

/// Each entry of an aggregate is an argument of its own.
std::vector<ValueId> Lowering::with_entries(std::span<const ValueId> arguments) {
  std::vector<ValueId> all;
  for (const ValueId argument : arguments) {
    const Type type = graph_.at(argument).type;
    if (!is_aggregate(type)) all.push_back(argument);
    for (uint32_t i = 0; is_aggregate(type) && i < type_components(type); ++i) all.push_back(entry(argument, i));
  }
  return all;
}

bool Lowering::is_spread(NodeId argument) const {
  return std::ranges::binary_search(checked_.spread_arguments, argument);
}

}  // namespace texbrdf::ir
