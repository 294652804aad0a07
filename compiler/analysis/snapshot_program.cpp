#include <algorithm>
#include <array>
#include <unordered_set>

#include "analysis/equation_text.h"
#include "analysis/root_arguments.h"
#include "analysis/snapshot_state.h"
#include "ir/lower.h"
#include "ir/passes/passes.h"
#include "semantics/parameter.h"

namespace texbrdf {
namespace {

ir::LinkableDefinition make_linkable(const LocatedDefinition& definition) {
  const AnalysedBlock& block = *definition.at.block->analysed;
  const DefinitionSyntax& syntax = definition.syntax();
  const CheckedDefinition& checked = definition.checked();

  ir::LinkableDefinition linkable;
  linkable.id = definition.name();
  linkable.name = read_name(block.parsed, syntax.name);
  linkable.canonical = canonical_form(linkable.name);
  linkable.signature = checked.signature;
  for (const CheckedParameter& parameter : checked.parameters) {
    linkable.formals.push_back(read_name(block.parsed, parameter.node));
  }
  linkable.graph = ir::lower_definition(block.parsed, syntax, block.names, checked);
  std::vector<Diagnostic> reported_already;
  linkable.literal = parameter_literal(block.parsed, syntax, reported_already);
  linkable.equation = one_line(block.parsed, syntax.node);
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

const ir::LinkableDefinition* Snapshot::linkable(NameId name) const {
  const std::optional<DefinitionKey> key = state_->find(name);
  if (!key) return nullptr;
  const LocatedDefinition definition = state_->locate(*key);
  if (!definition.checked().sound) return nullptr;
  return &definition.placed().record->linkable([&] { return make_linkable(definition); });
}

Result<ir::Program> Snapshot::program(std::string_view root, const ir::LinkOptions& options) const {
  const std::string wanted = root.empty() ? root_name() : std::string(root);
  const std::optional<DefinitionId> id = find(wanted);
  if (!id) return Failure{"no equation defines " + quoted(wanted)};
  const Definition& found = definition(*id);
  if (!found.checked->sound)
    return Failure{quoted(wanted) + " cannot be used: it or something that it needs has an error"};
  if (is_brdf(found.checked->signature)) {
    return ir::link([this](NameId name) { return linkable(name); }, found.name, options);
  }
  const auto arguments = root_arguments(*state_, *found.checked);
  if (!arguments) {
    return Failure{quoted(wanted) + " is " + signature_text(found.checked->signature) +
                   ", but a BRDF is ℝ or ℝ³, plain or a function of two vectors"};
  }
  const ir::LinkableDefinition call = call_of_root(*state_, state_->locate(*state_->find(found.name)), *arguments);
  return ir::link([&](NameId name) { return name == call.id ? &call : linkable(name); }, call.id, options);
}

std::optional<std::vector<double>> Snapshot::constant_value(DefinitionId id) const {
  const Definition& wanted = definition(id);
  const CheckedDefinition& checked = *wanted.checked;
  const bool may_be_constant =
      wanted.in_force && checked.sound && !state_->directional.contains(wanted.name, *state_->names);
  if (!may_be_constant || checked.signature.is_function || !needs_few(*state_, wanted.name)) return std::nullopt;
  const Result<ir::Program> program = ir::link([this](NameId name) { return linkable(name); }, wanted.name, {});
  if (!program) return std::nullopt;
  const Result<ir::Graph> flat = ir::flatten(*program);
  if (!flat) return std::nullopt;
  const ir::Graph folded = ir::fold_constants(with_numbers(*flat, *program));
  return constant_of(folded, folded.roots.front());
}

}  // namespace texbrdf
