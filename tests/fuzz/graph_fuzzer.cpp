// Any graph that keeps the rules of ops.def, also with what no document can say yet: it goes through every pass, can be
// evaluated and emitted. One that breaks a rule is told apart.
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "exercise.h"
#include "ir/differentiate.h"
#include "ir/passes/passes.h"
#include "ir/quadrature.h"
#include "support/program_of_graph.h"

namespace {

using namespace texbrdf;
using ir::Op;
using ir::ValueId;

constexpr std::size_t kMaxInput = 1 << 10;
constexpr int kParameters = 4;  // real and triple by turns
constexpr std::array kNumbers = {0.0, 1.0, -1.0, 2.0, 3.0, 0.5, -0.25, 1e-3, 7.0, 1e300, 70'000.0, 5e-324};

/// Builds a graph: a byte says the op, one more each operand or payload.
class GraphBuilder {
 public:
  explicit GraphBuilder(std::span<const uint8_t> bytes) : bytes_(bytes) {}

  ir::Graph build() {
    add_inputs();
    while (!bytes_.empty()) add_value(static_cast<Op>(next() % (static_cast<unsigned>(Op::Tanh) + 1)));
    graph_.roots = {last_number()};
    return std::move(graph_);
  }

 private:
  uint8_t next() {
    if (bytes_.empty()) return 0;
    const uint8_t byte = bytes_.front();
    bytes_ = bytes_.subspan(1);
    return byte;
  }

  void add_inputs() {
    for (int i = 0; i < kParameters; ++i) {
      graph_.leaf(Op::Parameter, i % 2 == 0 ? Type::Real : Type::Colour, static_cast<uint32_t>(i));
    }
    std::vector<ValueId> by_convention;
    for (const ConventionEntry& entry : conventions()) {
      std::vector<ValueId> operands;
      for (const Convention operand : entry.operands) operands.push_back(by_convention[static_cast<size_t>(operand)]);
      by_convention.push_back(graph_.convention(entry.id, operands));
    }
  }

  void add_value(Op op) {
    switch (op) {
      case Op::Constant:
        graph_.constant(kNumbers[next() % kNumbers.size()]);
        return;
      case Op::BoundVariable:
        if (graph_.binder_count() < ir::kMaxBinders) graph_.leaf(op, Type::Real, graph_.new_binder());
        return;
      case Op::Parameter:
      case Op::Convention:
      case Op::Reference:
      case Op::Formal:
      case Op::Call:
      case Op::MakeMatrix:
        return;  // all there already, or of several definitions
      default:
        add_operation(op);
    }
  }

  void add_operation(Op op) {
    const ir::OpEntry& entry = ir::op_entry(op);
    const uint32_t index = entry.payload == ir::Payload::Index ? next() % 4 : 0;
    std::vector<ValueId> operands;
    std::vector<Type> types;
    for (int i = 0; i < entry.least_operands; ++i) {
      operands.push_back(operand());
      types.push_back(graph_.at(operands.back()).type);
    }
    if (ir::result_type(op, types) != Type::Error) graph_.add(op, operands, index);
  }

  /// One of the last values of the type that the upper bits say, as far back as the lower bits say.
  ValueId operand() {
    static constexpr std::array kWanted = {Type::Real, Type::Real, Type::Vector, Type::Boolean};
    const uint8_t byte = next();
    const Type wanted = kWanted[byte >> 6];
    unsigned back = byte & 63U;
    ValueId nearest{graph_.size() - 1};
    for (uint32_t i = graph_.size(); i-- > 0;) {
      const Type type = graph_.at({i}).type;
      if (type != wanted && !(is_triple(type) && is_triple(wanted))) continue;
      nearest = {i};
      if (back-- == 0) break;
    }
    return nearest;
  }

  ValueId last_number() const {
    ValueId last{graph_.size() - 1};
    while (graph_.at(last).type == Type::Boolean) --last.value;
    return last;
  }

  std::span<const uint8_t> bytes_;
  ir::Graph graph_;
};

/// As the linker leaves it: without integrals and derivatives. Nothing where that would be too large.
std::optional<ir::Graph> expanded(const ir::Graph& graph) {
  const std::optional<ir::Graph> without_integrals = ir::expand_integrals(graph, ir::Fineness::Full);
  return without_integrals ? ir::expand_derivatives(*without_integrals, {}) : std::nullopt;
}

void run_each_pass(const ir::Graph& graph) {
  for (const auto passes : {ir::evaluation_passes(), ir::emission_passes()}) {
    ir::Graph current = graph;
    for (const ir::Pass& pass : passes) {
      current = pass.run(current);
      ir::validate(current, pass.name.data());
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
  if (size > kMaxInput) return 0;
  const ir::Graph built = GraphBuilder({data, size}).build();
  if (ir::find_fault(built)) return 0;
  std::optional<ir::Graph> graph = expanded(built);
  if (!graph) return 0;
  run_each_pass(*graph);
  test::exercise(test::program_of_graph(*std::move(graph), kParameters));
  return 0;
}
