#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "ir/differentiate.h"
#include "ir/link_entries.h"
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
  Linker(const DefinitionLookup& lookup, NameId root, Fineness fineness)
      : lookup_(lookup), root_(root), fineness_(fineness) {}

  Result<Program> run() {
    const LinkableDefinition* root = lookup_({root_, {}});
    if (root == nullptr) return Failure{"the definition that is asked for is missing or has errors"};
    if (const Type type = root->signature.result; is_aggregate(type)) {
      return Failure{fmt::format("`{}` is {}, which is no value of a program", root->canonical, type_symbol(type))};
    }
    open({root_, {}}, *root);
    while (!stack_.empty()) {
      if (auto failure = step()) return *std::move(failure);
    }
    return std::move(program_);
  }

 private:
  struct Frame {
    Instance instance;
    const LinkableDefinition* definition;
    uint32_t next_value = 0;
  };

  static bool is_use(const Value& value) { return value.op == Op::Reference || value.op == Op::Call; }

  Linked& linked(const Instance& instance) {
    return instance.parameters.empty() ? linked_[instance.function.value] : linked_instances_[instance];
  }

  const Linked* find_linked(const Instance& instance) const {
    if (instance.parameters.empty()) {
      const auto found = linked_.find(instance.function.value);
      return found == linked_.end() ? nullptr : &found->second;
    }
    const auto found = linked_instances_.find(instance);
    return found == linked_instances_.end() ? nullptr : &found->second;
  }

  void open(const Instance& instance, const LinkableDefinition& definition) {
    linked(instance) = {};
    stack_.push_back({instance, &definition});
  }

  /// Goes on with the innermost open definition up to its next use that is not linked yet, or closes it.
  std::optional<Failure> step() {
    Frame& frame = stack_.back();
    const auto values = frame.definition->graph.values();
    while (frame.next_value < values.size()) {
      const Value& value = values[frame.next_value++];
      if (!is_use(value)) continue;
      const Instance instance = used(frame.definition->graph, value);
      const Linked* const known = find_linked(instance);
      if (known == nullptr) return enter(instance, *frame.definition);
      if (known->state == Linked::State::Open) {
        return Failure{fmt::format("`{}` is defined by itself", frame.definition->canonical)};
      }
    }
    const Frame done = std::move(frame);
    stack_.pop_back();
    return close(done.instance, *done.definition);
  }

  std::optional<Failure> enter(const Instance& instance, const LinkableDefinition& user) {
    const LinkableDefinition* definition = lookup_(instance);
    if (definition == nullptr) {
      return Failure{fmt::format("`{}` uses a name whose definition is missing or has errors", user.canonical)};
    }
    if (definition->literal && !definition->signature.is_function) {
      add_parameter(*definition);
    } else {
      open(instance, *definition);
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

  std::optional<Failure> close(const Instance& instance, const LinkableDefinition& definition) {
    const auto first = static_cast<uint32_t>(program_.definitions.size());
    const std::vector<Graph> entries = link_entries(definition.graph, [this](const Instance& used) {
      const Linked& target = *find_linked(used);
      return LinkTarget{target.state == Linked::State::Parameter ? Op::Parameter : Op::Reference, target.index};
    });
    for (uint32_t i = 0; i < entries.size(); ++i) {
      if (auto failure = add_definition(definition, entries[i], i)) return failure;
    }
    linked(instance) = {Linked::State::Definition, first};
    return std::nullopt;
  }

  /// The entry of a definition of an aggregate type, or the whole of another.
  std::optional<Failure> add_definition(const LinkableDefinition& definition, const Graph& linked, uint32_t entry) {
    std::optional<Graph> graph = expand_integrals(linked, fineness_);
    if (graph) graph = expand_derivatives(*graph, program_.definitions);
    if (!graph) {
      return Failure{fmt::format("`{}` becomes too large when its integrals and derivatives are written out",
                                 definition.canonical)};
    }
    ProgramDefinition made = program_definition(definition);
    made.graph = *std::move(graph);
    if (const Type type = made.signature.result; is_aggregate(type)) {
      made.name = entry_name(definition.name, type_shape(type), entry);
      made.canonical = canonical_form(made.name);
      made.signature.result = Type::Real;
    }
    program_.definitions.push_back(std::move(made));
    return std::nullopt;
  }

  const DefinitionLookup& lookup_;
  NameId root_;
  const Fineness fineness_;
  Program program_;
  std::unordered_map<uint32_t, Linked> linked_;  // by NameId
  std::map<Instance, Linked> linked_instances_;
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
  Result<Program> program = Linker(lookup, root, options.fineness).run();
  if (!program) return program;
  for (const auto& [name, numbers] : options.values) {
    if (auto failure = set_parameter(*program, name, numbers)) return *std::move(failure);
  }
  return program;
}

}  // namespace texbrdf::ir
