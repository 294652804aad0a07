#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "ir/program.h"

namespace texbrdf::ir {

namespace {

/// What a name became in the program.
struct Linked {
  enum class State : uint8_t { Open, Definition, Parameter };
  State state = State::Open;
  uint32_t index = 0;
};

/// Walks depth first from the root, each definition's uses in order of first mention, on a stack of its own.
class Linker {
 public:
  Linker(const DefinitionLookup& lookup, NameId root) : lookup_(lookup), root_(root) {}

  Result<Program> run() {
    const LinkableDefinition* root = lookup_(root_);
    if (root == nullptr) return Failure{"the definition that is asked for is missing or has errors"};
    open(*root);
    while (!stack_.empty()) {
      if (auto failure = step()) return *std::move(failure);
    }
    return std::move(program_);
  }

 private:
  struct Frame {
    const LinkableDefinition* definition;
    uint32_t next_value = 0;
  };

  static bool is_use(const Value& value) { return value.op == Op::Reference || value.op == Op::Call; }

  void open(const LinkableDefinition& definition) {
    linked_[definition.id.value] = {};
    stack_.push_back({&definition});
  }

  /// Goes on with the innermost open definition up to its next use that is not linked yet, or closes it.
  std::optional<Failure> step() {
    Frame& frame = stack_.back();
    const auto values = frame.definition->graph.values();
    while (frame.next_value < values.size()) {
      const Value& value = values[frame.next_value++];
      if (!is_use(value)) continue;
      const auto known = linked_.find(value.index);
      if (known == linked_.end()) return enter(value.index, *frame.definition);
      if (known->second.state == Linked::State::Open) {
        return Failure{fmt::format("`{}` is defined by itself", frame.definition->canonical)};
      }
    }
    const LinkableDefinition& done = *frame.definition;
    stack_.pop_back();
    close(done);
    return std::nullopt;
  }

  std::optional<Failure> enter(uint32_t name, const LinkableDefinition& user) {
    const LinkableDefinition* definition = lookup_(NameId{name});
    if (definition == nullptr) {
      return Failure{fmt::format("`{}` uses a name whose definition is missing or has errors", user.canonical)};
    }
    if (definition->literal && !definition->signature.is_function) {
      add_parameter(*definition);
    } else {
      open(*definition);
    }
    return std::nullopt;
  }

  void add_parameter(const LinkableDefinition& definition) {
    const ParameterLiteral& literal = *definition.literal;
    linked_[definition.id.value] = {Linked::State::Parameter, static_cast<uint32_t>(program_.parameters.size())};
    program_.parameters.push_back({.id = definition.id,
                                   .name = definition.name,
                                   .canonical = definition.canonical,
                                   .type = literal.type,
                                   .value = literal.value,
                                   .minimum = literal.minimum,
                                   .maximum = literal.maximum,
                                   .equation = definition.equation});
  }

  void close(const LinkableDefinition& definition) {
    linked_[definition.id.value] = {Linked::State::Definition, static_cast<uint32_t>(program_.definitions.size())};
    program_.definitions.push_back({.id = definition.id,
                                    .name = definition.name,
                                    .canonical = definition.canonical,
                                    .signature = definition.signature,
                                    .formals = definition.formals,
                                    .graph = with_linked_uses(definition.graph),
                                    .equation = definition.equation});
  }

  Graph with_linked_uses(const Graph& graph) const {
    Graph result;
    for (uint32_t i = 0; i < graph.size(); ++i) {
      Value value = graph.at({i});
      if (is_use(value)) {
        const Linked& target = linked_.at(value.index);
        if (target.state == Linked::State::Parameter) value.op = Op::Parameter;
        value.index = target.index;
      }
      result.copy(value, graph.operands({i}));
    }
    result.roots = graph.roots;
    return result;
  }

  const DefinitionLookup& lookup_;
  NameId root_;
  Program program_;
  std::unordered_map<uint32_t, Linked> linked_;
  std::vector<Frame> stack_;
};

std::string parameter_list(const Program& program) {
  if (program.parameters.empty()) return "there are no parameters";
  std::vector<std::string> names;
  for (const Parameter& p : program.parameters) {
    names.push_back(fmt::format("`{}` ({})", p.canonical, p.type == Type::Real ? "a number" : "three numbers"));
  }
  return fmt::format("the parameters are {}", fmt::join(names, ", "));
}

std::optional<Failure> set_parameter(Program& program, const std::string& name, const std::vector<double>& numbers) {
  const auto parameter = std::find_if(program.parameters.begin(), program.parameters.end(),
                                      [&name](const Parameter& candidate) { return candidate.canonical == name; });
  if (parameter == program.parameters.end()) {
    return Failure{fmt::format("`{}` is no parameter; {}", name, parameter_list(program))};
  }
  const std::size_t wanted = type_components(parameter->type);
  if (numbers.size() != wanted) {
    return Failure{fmt::format("`{}` takes {}, got {}", name, wanted == 1 ? "1 number" : "3 numbers", numbers.size())};
  }
  for (std::size_t i = 0; i < wanted; ++i) {
    if (!std::isfinite(numbers[i])) return Failure{fmt::format("`{}` takes finite numbers only", name)};
    parameter->value[i] = numbers[i];
    parameter->minimum = std::min(parameter->minimum, numbers[i]);
    parameter->maximum = std::max(parameter->maximum, numbers[i]);
  }
  return std::nullopt;
}

}  // namespace

Result<Program> link(const DefinitionLookup& lookup, NameId root, const LinkOptions& options) {
  Result<Program> program = Linker(lookup, root).run();
  if (!program) return program;
  for (const auto& [name, numbers] : options.values) {
    if (auto failure = set_parameter(*program, name, numbers)) return *std::move(failure);
  }
  return program;
}

}  // namespace texbrdf::ir
