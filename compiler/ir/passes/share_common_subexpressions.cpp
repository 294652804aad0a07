#include <algorithm>
#include <bit>
#include <unordered_map>

#include "ir/passes/passes.h"
#include "ir/passes/rewrite.h"

namespace texbrdf::ir {

namespace {

/// a∘b and b∘a are the same number to the last bit. Not so for Min and Max of +0 and −0.
bool is_commutative(Op op) {
  return op == Op::Add || op == Op::Multiply || op == Op::Dot || op == Op::Equal || op == Op::And || op == Op::Or;
}

using Operands = std::vector<ValueId>;

Operands in_key_order(Op op, std::span<const ValueId> operands) {
  Operands ordered(operands.begin(), operands.end());
  if (is_commutative(op)) std::sort(ordered.begin(), ordered.end());
  return ordered;
}

uint64_t hash_of(const Value& value, const Operands& operands) {
  constexpr uint64_t kMultiplier = 0x9E3779B97F4A7C15u;
  uint64_t hash = static_cast<uint64_t>(value.op);
  const auto mix = [&hash](uint64_t part) { hash = std::rotl((hash ^ part) * kMultiplier, 29); };
  mix(static_cast<uint64_t>(value.type));
  mix(value.index);
  mix(std::bit_cast<uint64_t>(value.constant));
  for (const ValueId operand : operands) mix(operand.value);
  return hash;
}

/// Equal operands include equal binder ids, so a value is only shared within the reductions that it depends on.
class Sharing {
 public:
  ValueId find_or_copy(Graph& graph, const Value& value, std::span<const ValueId> operands) {
    const Operands key = in_key_order(value.op, operands);
    const uint64_t hash = hash_of(value, key);
    const auto [first, last] = by_hash_.equal_range(hash);
    const auto known =
        std::find_if(first, last, [&](const auto& entry) { return same(graph, entry.second, value, key); });
    if (known != last) return known->second;
    const ValueId added = graph.copy(value, operands);
    by_hash_.emplace(hash, added);
    return added;
  }

 private:
  static bool same(const Graph& graph, ValueId known, const Value& value, const Operands& key) {
    const Value& other = graph.at(known);
    return other.op == value.op && other.type == value.type && other.index == value.index &&
           std::bit_cast<uint64_t>(other.constant) == std::bit_cast<uint64_t>(value.constant) &&
           in_key_order(other.op, graph.operands(known)) == key;
  }

  std::unordered_multimap<uint64_t, ValueId> by_hash_;
};

}  // namespace

Graph share_common_subexpressions(const Graph& graph) {
  Sharing sharing;
  return rewrite(graph, [&](Graph& result, ValueId id, std::span<const ValueId> operands) {
    return sharing.find_or_copy(result, graph.at(id), operands);
  });
}

}  // namespace texbrdf::ir
