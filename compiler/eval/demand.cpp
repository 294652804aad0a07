#include "eval/demand.h"

namespace texbrdf::eval {

namespace {

using ir::Op;
using ir::ValueId;

constexpr uint8_t kFirst = 1;
constexpr uint8_t kAll = 7;

/// Component i of a cross product needs the other two of its operands.
uint8_t others(uint8_t components) {
  uint8_t result = 0;
  for (unsigned i = 0; i < 3; ++i) {
    if ((components & (1u << i)) != 0) result |= kAll & ~(1u << i);
  }
  return result;
}

class Demand {
 public:
  explicit Demand(const ir::Graph& graph) : graph_(graph), demanded_(graph.size(), 0) {
    for (const ValueId root : graph.roots) demand(root, kAll);
    for (uint32_t i = graph.size(); i-- > 0;) {
      if (demanded_[i] != 0) demand_operands({i}, demanded_[i]);
    }
  }

  std::vector<uint8_t> take() { return std::move(demanded_); }

 private:
  void demand(ValueId value, uint8_t components) {
    demanded_[value.value] |= is_triple(graph_.at(value).type) ? components : kFirst;
  }

  void demand_operands(ValueId value, uint8_t components) {
    const ir::Value& v = graph_.at(value);
    const auto operands = graph_.operands(value);
    if (v.op == Op::MakeVector) {
      for (unsigned i = 0; i < 3; ++i) {
        if ((components & (1u << i)) != 0) demand(operands[i], kFirst);
      }
      return;
    }
    for (const ValueId operand : operands) demand(operand, of_operand(v, components));
  }

  static uint8_t of_operand(const ir::Value& user, uint8_t components) {
    if (user.op == Op::Component) return static_cast<uint8_t>(1u << user.index);
    if (user.op == Op::Dot) return kAll;
    return user.op == Op::Cross ? others(components) : components;
  }

  const ir::Graph& graph_;
  std::vector<uint8_t> demanded_;
};

}  // namespace

std::vector<uint8_t> demanded_components(const ir::Graph& graph) {
  return Demand(graph).take();
}

}  // namespace texbrdf::eval
