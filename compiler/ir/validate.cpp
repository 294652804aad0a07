#include "ir/validate.h"

#include <fmt/format.h>

#include <algorithm>

#include "source/internal_error.h"

namespace texbrdf::ir {

namespace {

using Fault = std::optional<std::string>;

/// The kinds of triples are one for graphs.
bool compatible(Type a, Type b) {
  return a == b || (is_triple(a) && is_triple(b));
}

bool has_outside_type(Op op) {
  return op == Op::Parameter || op == Op::Reference || op == Op::Formal || op == Op::Call || op == Op::MakeMatrix;
}

class GraphValidator {
 public:
  explicit GraphValidator(const Graph& graph) : graph_(graph) {}

  Fault run() {
    for (uint32_t i = 0; i < graph_.size(); ++i) {
      if (const Fault fault = value_fault({i})) return fmt::format("%{}: {}", i, *fault);
    }
    return roots_fault();
  }

 private:
  Fault value_fault(ValueId id) {
    const Value& value = graph_.at(id);
    for (const ValueId operand : graph_.operands(id)) {
      if (operand >= id) return "an operand that does not come before its user";
    }
    if (Fault fault = count_fault(value)) return fault;
    if (Fault fault = payload_fault(value)) return fault;
    if (Fault fault = type_fault(id)) return fault;
    return binder_fault(id);
  }

  static Fault count_fault(const Value& value) {
    const OpEntry& entry = op_entry(value.op);
    const int count = static_cast<int>(value.operand_count);
    if (count < entry.least_operands || (entry.most_operands >= 0 && count > entry.most_operands)) {
      return fmt::format("{} with {} operands", entry.printed, count);
    }
    return std::nullopt;
  }

  static Fault payload_fault(const Value& value) {
    const Payload payload = op_entry(value.op).payload;
    if (payload != Payload::Index && value.index != 0) return "an index that its op does not have";
    if (payload != Payload::Constant && value.constant != 0) return "a constant that its op does not have";
    if (value.op == Op::Component && value.index > 2) return "a component beyond the third";
    if (value.op == Op::Convention && value.index >= conventions().size()) return "a convention that does not exist";
    const bool has_binder = value.op == Op::BoundVariable || binds(value.op);
    if (has_binder && value.index >= kMaxBinders) return "a binder id out of range";
    return std::nullopt;
  }

  Fault type_fault(ValueId id) const {
    const Value& value = graph_.at(id);
    if (value.op == Op::Convention) return convention_fault(id);
    if (value.op == Op::BoundVariable) return expect(value.type == Type::Real, "a bound variable that is not real");
    if (has_outside_type(value.op)) return expect(value.type != Type::Error, "a value without a type");
    std::vector<Type> types;
    for (const ValueId operand : graph_.operands(id)) types.push_back(graph_.at(operand).type);
    const Type expected = result_type(value.op, types);
    if (expected == Type::Error) return fmt::format("{} of operands that do not fit", op_entry(value.op).printed);
    return expect(compatible(expected, value.type), "a type that does not follow from its operands");
  }

  Fault convention_fault(ValueId id) const {
    const Value& value = graph_.at(id);
    const ConventionEntry& entry = convention_entry(static_cast<Convention>(value.index));
    if (value.type != entry.type) return "a convention of another type";
    if (value.operand_count != entry.operands.size()) return "a convention with another number of operands";
    for (uint32_t i = 0; i < value.operand_count; ++i) {
      const Type expected = convention_entry(entry.operands[i]).type;
      if (!compatible(graph_.at(graph_.operand(id, i)).type, expected))
        return "a convention with an operand of another type";
    }
    return std::nullopt;
  }

  Fault binder_fault(ValueId id) {
    const Value& value = graph_.at(id);
    if (!binds(value.op)) return std::nullopt;
    const BinderSet bit = BinderSet{1} << value.index;
    if ((bound_ & bit) != 0) return "a binder of two reductions";
    bound_ |= bit;
    BinderSet range = 0;
    for (uint32_t i = 0; i + 1 < value.operand_count; ++i) range |= graph_.at(graph_.operand(id, i)).binders;
    return expect((range & bit) == 0, "a range that depends on its own binder");
  }

  Fault roots_fault() const {
    if (graph_.roots.empty()) return "no root";
    for (const ValueId root : graph_.roots) {
      if (root.value >= graph_.size()) return "a root that does not exist";
      if (graph_.at(root).binders != 0) return "a root with an unbound variable";
    }
    return std::nullopt;
  }

  static Fault expect(bool condition, const char* otherwise) { return condition ? Fault{} : Fault{otherwise}; }

  const Graph& graph_;
  BinderSet bound_ = 0;
};

class ProgramValidator {
 public:
  explicit ProgramValidator(const Program& program) : program_(program) {}

  Fault run() const {
    if (program_.definitions.empty()) return "a program without a root";
    for (const Parameter& p : program_.parameters) {
      if (p.type != Type::Real && p.type != Type::Colour)
        return fmt::format("{}: a parameter of another type", p.canonical);
      if (!(p.minimum <= p.maximum)) return fmt::format("{}: an empty range", p.canonical);
    }
    for (uint32_t i = 0; i < program_.definitions.size(); ++i) {
      if (const Fault fault = definition_fault(i)) {
        return fmt::format("{}: {}", program_.definitions[i].canonical, *fault);
      }
    }
    return std::nullopt;
  }

 private:
  Fault definition_fault(uint32_t own) const {
    const ProgramDefinition& definition = program_.definitions[own];
    const Graph& graph = definition.graph;
    if (Fault fault = GraphValidator(graph).run()) return fault;
    const auto is_matrix = [](const Value& value) { return is_aggregate(value.type); };
    if (std::ranges::any_of(graph.values(), is_matrix)) return "a matrix after linking";
    if (graph.roots.size() != 1) return "a definition with several roots";
    if (!compatible(graph.at(graph.roots[0]).type, definition.signature.result)) return "a root of another type";
    if (definition.formals.size() != definition.signature.parameters.size()) return "formals that do not fit";
    for (uint32_t i = 0; i < graph.size(); ++i) {
      if (const char* fault = link_fault(own, {i})) return fmt::format("%{}: {}", i, fault);
    }
    return std::nullopt;
  }

  const char* link_fault(uint32_t own, ValueId id) const {
    const ProgramDefinition& definition = program_.definitions[own];
    const Value& value = definition.graph.at(id);
    if (value.op == Op::Integral || value.op == Op::Derivative) return "what linking expands";
    if (value.op == Op::Formal) {
      const auto& formals = definition.signature.parameters;
      return value.index < formals.size() && compatible(formals[value.index], value.type) ? nullptr : "no such formal";
    }
    if (value.op == Op::Parameter) {
      const auto& parameters = program_.parameters;
      const bool fits = value.index < parameters.size() && compatible(parameters[value.index].type, value.type);
      return fits ? nullptr : "no such parameter";
    }
    if (value.op != Op::Reference && value.op != Op::Call) return nullptr;
    if (value.index >= own) return "a definition that does not come before its user";
    return use_fault(definition.graph, id, program_.definitions[value.index].signature);
  }

  static const char* use_fault(const Graph& graph, ValueId id, const Signature& used) {
    const Value& value = graph.at(id);
    if (used.is_function != (value.op == Op::Call)) return "a call of what is no function, or a function as a value";
    if (!compatible(used.result, value.type)) return "a definition of another type";
    if (used.parameters.size() != value.operand_count) return "a wrong number of arguments";
    for (uint32_t i = 0; i < value.operand_count; ++i) {
      if (!compatible(graph.at(graph.operand(id, i)).type, used.parameters[i])) return "an argument of another type";
    }
    return nullptr;
  }

  const Program& program_;
};

}  // namespace

std::optional<std::string> find_fault(const Graph& graph) {
  return GraphValidator(graph).run();
}

std::optional<std::string> find_fault(const Program& program) {
  return ProgramValidator(program).run();
}

void validate(const Graph& graph, const char* where) {
  if (const Fault fault = find_fault(graph)) throw InternalError(fmt::format("{}: {}", where, *fault));
}

}  // namespace texbrdf::ir
