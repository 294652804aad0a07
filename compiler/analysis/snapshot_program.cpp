#include <algorithm>
#include <array>
#include <functional>
#include <unordered_set>

#include "analysis/equation_text.h"
#include "analysis/root_arguments.h"
#include "analysis/snapshot_facts.h"
#include "analysis/snapshot_state.h"
#include "ir/free_name.h"
#include "ir/lower.h"
#include "ir/passes/passes.h"
#include "semantics/parameter.h"
#include "syntax/control_words.h"

namespace texbrdf {
namespace {

/// What generated code calls a parameter.
Name formal_name(const AnalysedBlock& block, const NameTable& table, const CheckedParameter& parameter) {
  Name name;
  name.base = "argument";
  if (!parameter.name.valid()) return name;
  const bool stands_itself = block.names.by_node[parameter.node.value] == parameter.name;
  name = stands_itself ? read_name(block.parsed, parameter.node) : *name_spelled(table.text(parameter.name));
  if (parameter.function == Command::None) return name;
  name.base = std::string(command_spelling(parameter.function)) + "_" + name.base;
  name.is_command = false;
  name.is_text = true;
  return name;
}

bool has_expressions(const CheckedDefinition& function) {
  return std::ranges::any_of(function.parameters, [](const CheckedParameter& p) { return !p.name.valid(); });
}

ir::LinkableDefinition make_linkable(const NameTable& table, const LocatedDefinition& definition,
                                     const CheckedDefinition& checked,
                                     ir::Expressions expressions = ir::Expressions::AreArguments) {
  const AnalysedBlock& block = *definition.at.block->analysed;
  const DefinitionSyntax& syntax = definition.syntax();

  ir::LinkableDefinition linkable;
  linkable.id = definition.name();
  linkable.name = read_name(block.parsed, syntax.name);
  linkable.canonical = canonical_form(linkable.name);
  linkable.signature = checked.signature;
  for (const CheckedParameter& parameter : checked.parameters) {
    linkable.formals.push_back(formal_name(block, table, parameter));
  }
  linkable.graph = ir::lower_definition(block.parsed, syntax, block.names, checked, expressions);
  std::vector<Diagnostic> reported_already;
  linkable.literal = parameter_literal(block.parsed, syntax, reported_already);
  linkable.equation = one_line(block.parsed, syntax.node);
  return linkable;
}

/// `g_vec3`: its types, where they are others than the function takes by itself.
Name instance_name(Name function, const Signature& own, const std::vector<Type>& parameters) {
  std::vector<std::string> words;
  for (size_t i = 0; i < parameters.size(); ++i) {
    if (parameters[i] != own.parameters[i]) words.push_back(type_word(parameters[i]));
  }
  const bool are_alike = std::ranges::adjacent_find(words, std::ranges::not_equal_to()) == words.end();
  if (are_alike) words.resize(1);
  for (std::string& word : words) function.subscripts.push_back(std::move(word));
  return function;
}

ir::LinkableDefinition make_instance(const Snapshot& snapshot, const LocatedDefinition& definition,
                                     const std::vector<Type>& parameters) {
  const AnalysedBlock& block = *definition.at.block->analysed;
  const CheckedDefinition checked = check_instance(block.parsed, definition.syntax(), block.names, snapshot.names(),
                                                   SnapshotFacts(snapshot), parameters);
  ir::LinkableDefinition linkable = make_linkable(snapshot.names(), definition, checked);
  linkable.name = instance_name(linkable.name, definition.checked().signature, parameters);
  return linkable;
}

std::string quoted(std::string_view name) {
  return "`" + std::string(name) + "`";
}

/// The graph with every parameter and constant of the convention as the number that it is now.
ir::Graph with_numbers(const ir::Graph& graph, const ir::Program& program) {
  ir::Graph out;
  std::vector<ir::ValueId> copies;
  std::vector<ir::ValueId> operands;
  const auto number = [&](const ir::Value& value) -> std::optional<ir::ValueId> {
    if (value.op == ir::Op::Parameter) {
      const ir::Parameter& parameter = program.parameters[value.index];
      if (parameter.type == Type::Real) return out.constant(parameter.value[0]);
      const std::array<ir::ValueId, 3> components = {out.constant(parameter.value[0]), out.constant(parameter.value[1]),
                                                     out.constant(parameter.value[2])};
      return out.add(ir::Op::MakeVector, components);
    }
    if (value.op != ir::Op::Convention) return std::nullopt;
    const std::optional<double> constant = convention_constant(static_cast<Convention>(value.index));
    return constant ? std::optional(out.constant(*constant)) : std::nullopt;
  };
  for (uint32_t id = 0; id < graph.size(); ++id) {
    const ir::Value& value = graph.at({id});
    operands.clear();
    for (ir::ValueId operand : graph.operands({id})) operands.push_back(copies[operand.value]);
    const std::optional<ir::ValueId> replaced = number(value);
    copies.push_back(replaced ? *replaced : out.copy(value, operands));
  }
  for (ir::ValueId root : graph.roots) out.roots.push_back(copies[root.value]);
  return out;
}

std::optional<std::vector<double>> constant_of(const ir::Graph& graph, ir::ValueId root) {
  std::vector<double> numbers;
  const auto take = [&](ir::ValueId id) {
    const bool is_constant = graph.at(id).op == ir::Op::Constant;
    if (is_constant) numbers.push_back(graph.at(id).constant);
    return is_constant;
  };
  if (graph.at(root).op != ir::Op::MakeVector) {
    if (!take(root)) return std::nullopt;
  } else if (!std::ranges::all_of(graph.operands(root), take)) {
    return std::nullopt;
  }
  return numbers;
}

// Values are shown while somebody waits for them.
constexpr size_t kMostDefinitions = 200;

bool needs_few(const Snapshot::State& state, NameId root) {
  std::unordered_set<uint32_t> needed = {root.value};
  std::vector<NameId> waiting = {root};
  while (!waiting.empty()) {
    const std::optional<DefinitionKey> key = state.find(waiting.back());
    waiting.pop_back();
    if (!key) continue;
    for (NameId name : state.locate(*key).at.block->analysed->mentions_of(key->index_in_block)) {
      if (needed.insert(name.value).second) waiting.push_back(name);
    }
    if (needed.size() > kMostDefinitions) return false;
  }
  return true;
}

}  // namespace

const ir::LinkableDefinition* Snapshot::linkable(const Instance& instance) const {
  const std::optional<DefinitionKey> key = state_->find(instance.function);
  if (!key) return nullptr;
  const LocatedDefinition definition = state_->locate(*key);
  if (!definition.checked().sound) return nullptr;
  const DefinitionRecord& record = *definition.placed().record;
  if (instance.parameters.empty()) {
    return &record.linkable([&] { return make_linkable(*state_->names, definition, definition.checked()); });
  }
  return &record.linkable_as(instance.parameters,
                             [&] { return make_instance(*this, definition, instance.parameters); });
}

Result<ir::Program> Snapshot::program(std::string_view root, const ir::LinkOptions& options) const {
  const std::string wanted = root.empty() ? root_name() : std::string(root);
  const std::optional<DefinitionId> id = find(wanted);
  if (!id) return Failure{"no equation defines " + quoted(wanted)};
  const Definition& found = definition(*id);
  const auto unusable = [&] {
    return Failure{quoted(wanted) + " cannot be used: it or something that it needs has an error"};
  };
  if (!found.checked->sound) return unusable();
  const auto own = [this](const Instance& instance) { return linkable(instance); };
  if (is_brdf(found.checked->signature)) {
    return ir::link(own, found.name, options);
  }
  const LocatedDefinition located = state_->locate(*state_->find(found.name));
  const auto arguments = root_arguments(*state_, located);
  if (!arguments && found.checked->signature.has_implied_parameters) return unusable();
  if (!arguments) {
    return Failure{quoted(wanted) + " is " + signature_text(found.checked->signature) +
                   ", but a BRDF is ℝ or ℝ³, plain or a function of two vectors"};
  }
  if (!has_expressions(*found.checked)) {
    const ir::LinkableDefinition call = call_of_root(*state_, located, found.name, *arguments);
    const auto lookup = [&](const Instance& use) { return use.function == call.id ? &call : own(use); };
    return ir::link(lookup, call.id, options);
  }
  ir::LinkableDefinition function =
      make_linkable(*state_->names, located, located.checked(), ir::Expressions::AreWrittenOut);
  function.id = ir::free_name(1);
  const ir::LinkableDefinition call = call_of_root(*state_, located, function.id, *arguments);
  const auto lookup = [&](const Instance& use) {
    if (use.function == call.id) return &call;
    return use.function == function.id ? &function : own(use);
  };
  return ir::link(lookup, call.id, options);
}

std::optional<std::vector<double>> Snapshot::constant_value(DefinitionId id) const {
  const Definition& wanted = definition(id);
  const CheckedDefinition& checked = *wanted.checked;
  const bool may_be_constant =
      wanted.in_force && checked.sound && !state_->directional.contains(wanted.name, *state_->names);
  if (!may_be_constant || checked.signature.is_function || !needs_few(*state_, wanted.name)) return std::nullopt;
  const Result<ir::Program> program =
      ir::link([this](const Instance& instance) { return linkable(instance); }, wanted.name, {});
  if (!program) return std::nullopt;
  const Result<ir::Graph> flat = ir::flatten(*program);
  if (!flat) return std::nullopt;
  const ir::Graph folded = ir::fold_constants(with_numbers(*flat, *program));
  return constant_of(folded, folded.roots.front());
}

}  // namespace texbrdf
