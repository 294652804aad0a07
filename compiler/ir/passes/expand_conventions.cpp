#include <algorithm>

#include "ir/passes/direction_values.h"
#include "ir/passes/passes.h"
#include "ir/passes/rewrite.h"

namespace texbrdf::ir {

namespace {

ValueId half_vector(Graph& graph, ValueId light, ValueId view) {
  const ValueId sum = graph.add(Op::Add, {light, view});
  const ValueId length = graph.add(Op::Sqrt, {graph.add(Op::Dot, {sum, sum})});
  return graph.add(Op::Divide, {sum, length});
}

ValueId azimuth(Graph& graph, std::span<const ValueId> operands) {
  const ValueId x = graph.add(Op::Dot, {operands[2], operands[0]});
  const ValueId y = graph.add(Op::Dot, {operands[2], operands[1]});
  return graph.add(Op::Arctan2, {y, x});
}

/// The convention as conventions.def says it is made of its operands.
ValueId expand(Graph& graph, const Value& value, std::span<const ValueId> operands) {
  const auto id = static_cast<Convention>(value.index);
  switch (id) {
    case Convention::OmegaI:
    case Convention::OmegaO:
    case Convention::Normal:
    case Convention::Tangent:
    case Convention::Bitangent:
      return graph.copy(value, operands);
    case Convention::Pi:
    case Convention::Epsilon:
    case Convention::Euler:
      return graph.constant(*convention_constant(id));
    case Convention::Half:
      return half_vector(graph, operands[0], operands[1]);
    case Convention::ThetaI:
    case Convention::ThetaO:
    case Convention::ThetaH:
    case Convention::ThetaD:
      return graph.add(Op::Arccos, {clamped_cosine(graph, operands[0], operands[1])});
    case Convention::PhiI:
    case Convention::PhiO:
    case Convention::PhiH:
      return azimuth(graph, operands);
  }
  return graph.copy(value, operands);
}

/// For each value, whether it is a convention made of nothing but the conventions that conventions.def names for it.
std::vector<bool> find_unchanged_conventions(const Graph& graph) {
  std::vector<bool> unchanged(graph.size());
  for (uint32_t i = 0; i < graph.size(); ++i) {
    const Value& value = graph.at({i});
    if (value.op != Op::Convention) continue;
    const ConventionEntry& entry = convention_entry(static_cast<Convention>(value.index));
    const auto operands = graph.operands({i});
    unchanged[i] =
        std::equal(operands.begin(), operands.end(), entry.operands.begin(), entry.operands.end(),
                   [&](ValueId operand, Convention expected) {
                     return unchanged[operand.value] && graph.at(operand).index == static_cast<uint32_t>(expected);
                   });
  }
  return unchanged;
}

}  // namespace

Graph expand_conventions(const Graph& graph) {
  return rewrite(graph, [&graph](Graph& result, ValueId id, std::span<const ValueId> operands) {
    const Value& value = graph.at(id);
    return value.op == Op::Convention ? expand(result, value, operands) : result.copy(value, operands);
  });
}

Graph expand_shadowed_conventions(const Graph& graph) {
  const std::vector<bool> unchanged = find_unchanged_conventions(graph);
  return rewrite(graph, [&](Graph& result, ValueId id, std::span<const ValueId> operands) {
    const Value& value = graph.at(id);
    const bool shadowed = value.op == Op::Convention && !unchanged[id.value];
    return shadowed ? expand(result, value, operands) : result.copy(value, operands);
  });
}

}  // namespace texbrdf::ir
