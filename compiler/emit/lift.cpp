#include "emit/lift.h"

#include <array>
#include <optional>
#include <set>
#include <utility>

#include "emit/merge.h"
#include "emit/namer.h"
#include "ir/passes/rewrite.h"

namespace texbrdf::emit {
namespace {

using ir::Graph;
using ir::Op;
using ir::Value;
using ir::ValueId;

/// Captures in all functions together; a program with more has functions that call each other in long chains.
constexpr std::size_t kMostCaptures = 200'000;

bool is_input(const Value& value) {
  return value.op == Op::Convention && value.operand_count == 0 &&
         !convention_constant(static_cast<Convention>(value.index));
}

/// What each definition is once plain renamings of inputs are seen through.
class Renamings {
 public:
  explicit Renamings(const ir::Program& program) : input_of_(program.definitions.size()) {
    for (std::size_t i = 0; i + 1 < program.definitions.size(); ++i) {
      const ir::ProgramDefinition& definition = program.definitions[i];
      if (definition.signature.is_function) continue;
      const Value& value = definition.graph.at(definition.graph.roots[0]);
      std::optional<Convention> input;
      if (is_input(value)) input = static_cast<Convention>(value.index);
      if (value.op == Op::Reference) input = input_of_[value.index];
      if (input && identifier(definition.name) == convention_entry(*input).symbol) input_of_[i] = input;
    }
  }
  std::optional<Convention> input(const Value& value) const {
    return value.op == Op::Reference ? input_of_[value.index] : std::nullopt;
  }

 private:
  std::vector<std::optional<Convention>> input_of_;
};

class Lifter {
 public:
  Lifter(const ir::Program& program, ParameterScope scope)
      : program_(program), renamings_(program), scope_(scope), captures_(program.definitions.size()) {}

  Result<LiftedProgram> run() {
    std::vector<Graph> graphs;
    std::size_t total = 0;
    for (uint32_t i = 0; i < program_.definitions.size(); ++i) {
      const ir::ProgramDefinition& definition = program_.definitions[i];
      graphs.push_back(lifted_graph(definition.graph));
      if (!is_lifted(i)) continue;
      captures_[i] = captures_of(graphs[i]);
      total += captures_[i].size();
      if (total > kMostCaptures)
        return Failure{"the functions of this document use too many definitions to be compiled"};
    }
    return assemble(graphs);
  }

 private:
  bool is_root(uint32_t definition) const { return definition + 1 == program_.definitions.size(); }
  bool is_lifted(uint32_t definition) const {
    return program_.definitions[definition].signature.is_function && !is_root(definition);
  }

  /// Calls get the captures of their callee as operands. Callees stand before callers.
  Graph lifted_graph(const Graph& graph) const {
    return ir::rewrite(graph, [&](Graph& result, ValueId id, std::span<const ValueId> operands) {
      const Value& value = graph.at(id);
      if (auto input = renamings_.input(value)) return result.convention(*input);
      if (value.op != Op::Call) return result.copy(value, operands);
      std::vector<ValueId> all(operands.begin(), operands.end());
      for (const Capture& capture : captures_[value.index]) all.push_back(captured_value(result, capture));
      return result.leaf(Op::Call, value.type, value.index, all);
    });
  }

  ValueId captured_value(Graph& graph, const Capture& capture) const {
    switch (capture.kind) {
      case Capture::Kind::Input:
        return graph.convention(static_cast<Convention>(capture.index));
      case Capture::Kind::Parameter:
        return graph.leaf(Op::Parameter, program_.parameters[capture.index].type, capture.index);
      case Capture::Kind::Definition:
        return graph.leaf(Op::Reference, program_.definitions[capture.index].signature.result, capture.index);
      case Capture::Kind::Derived:
        break;
    }
    std::vector<ValueId> operands;
    for (Convention operand : convention_entry(static_cast<Convention>(capture.index)).operands) {
      bool derived = !convention_entry(operand).operands.empty();
      operands.push_back(captured_value(
          graph, {derived ? Capture::Kind::Derived : Capture::Kind::Input, static_cast<uint32_t>(operand)}));
    }
    return graph.convention(static_cast<Convention>(capture.index), operands);
  }

  std::vector<Capture> captures_of(const Graph& graph) const {
    std::set<Capture> captures;
    std::vector<bool> seen(graph.size());
    std::vector<ValueId> open{graph.roots[0]};
    while (!open.empty()) {
      ValueId id = open.back();
      open.pop_back();
      if (seen[id.value]) continue;
      seen[id.value] = true;
      if (auto capture = capture_of(graph.at(id))) {
        captures.insert(*capture);
      } else {
        open.insert(open.end(), graph.operands(id).begin(), graph.operands(id).end());
      }
    }
    return {captures.begin(), captures.end()};
  }

  std::optional<Capture> capture_of(const Value& value) const {
    if (is_input(value)) return Capture{Capture::Kind::Input, value.index};
    if (value.op == Op::Convention && value.operand_count > 0) return Capture{Capture::Kind::Derived, value.index};
    if (value.op == Op::Reference) return Capture{Capture::Kind::Definition, value.index};
    if (value.op == Op::Parameter && scope_ == ParameterScope::EntryPoint)
      return Capture{Capture::Kind::Parameter, value.index};
    return std::nullopt;
  }

  /// By index: whether the root needs the definition.
  std::vector<bool> needed(const std::vector<Graph>& graphs, std::vector<bool>& parameter_used) const {
    std::vector<bool> result(graphs.size());
    result.back() = true;
    for (std::size_t i = graphs.size(); i-- > 0;) {
      if (!result[i]) continue;
      visit_reachable(graphs[i], [&](const Value& value) {
        if (value.op == Op::Reference || value.op == Op::Call) result[value.index] = true;
        if (value.op == Op::Parameter) parameter_used[value.index] = true;
      });
    }
    return result;
  }

  template <typename Visit>
  static void visit_reachable(const Graph& graph, Visit&& visit) {
    std::vector<bool> live(graph.size());
    for (ValueId root : graph.roots) live[root.value] = true;
    for (uint32_t i = graph.size(); i-- > 0;) {
      if (!live[i]) continue;
      visit(graph.at({i}));
      for (ValueId operand : graph.operands({i})) live[operand.value] = true;
    }
  }

  LiftedProgram assemble(std::vector<Graph>& graphs) {
    LiftedProgram lifted;
    lifted.parameter_used.resize(program_.parameters.size());
    std::vector<bool> live = needed(graphs, lifted.parameter_used);
    Merger body;
    for (uint32_t i = 0; i < graphs.size(); ++i) {
      if (!live[i]) continue;
      if (is_lifted(i)) {
        Merger function;
        function.append(graphs[i]);
        lifted.functions.push_back({i, std::move(captures_[i]), function.take()});
      } else {
        body.append(graphs[i]);
        lifted.definitions.push_back(i);
      }
    }
    lifted.body = body.take();
    return lifted;
  }

  const ir::Program& program_;
  Renamings renamings_;
  ParameterScope scope_;
  std::vector<std::vector<Capture>> captures_;
};

}  // namespace

Result<LiftedProgram> lift(const ir::Program& program, ParameterScope scope) {
  return Lifter(program, scope).run();
}

ir::Program with_directions_for_root_formals(ir::Program program) {
  ir::ProgramDefinition& root = program.definitions.back();
  const Graph& graph = root.graph;
  constexpr std::array kDirections{Convention::OmegaI, Convention::OmegaO};
  root.graph = ir::rewrite(graph, [&](Graph& result, ValueId id, std::span<const ValueId> operands) {
    const Value& value = graph.at(id);
    if (value.op == Op::Formal && value.index < kDirections.size()) return result.convention(kDirections[value.index]);
    return result.copy(value, operands);
  });
  return program;
}

}  // namespace texbrdf::emit
