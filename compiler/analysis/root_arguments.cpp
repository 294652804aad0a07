#include "analysis/root_arguments.h"

#include <algorithm>

#include "analysis/equation_text.h"

namespace texbrdf {
namespace {

/// Beside its own place on the left side.
bool is_used(const CheckedDefinition& definition, uint32_t position) {
  const Referent parameter{.kind = Referent::Kind::Parameter, .index = position};
  return std::ranges::count(definition.referents, parameter) > 1;
}

/// `x` is a position, which may stand there if the BRDF does not depend on it.
bool is_tangent(Convention meaning) {
  return meaning == Convention::Tangent || meaning == Convention::Bitangent;
}

std::optional<RootArgument> argument_of(const Snapshot::State& state, const CheckedDefinition& root,
                                        uint32_t position) {
  const CheckedParameter& parameter = root.parameters[position];
  if (!parameter.name.valid()) return std::nullopt;
  if (const std::optional<DefinitionKey> key = state.find(parameter.name)) {
    const Signature& signature = state.locate(*key).checked().signature;
    if (signature.is_function || !fits(signature.result, parameter.type)) return std::nullopt;
    return parameter.name;
  }
  const std::optional<Convention> meaning = state.names->traits(parameter.name).meaning();
  if (!meaning || !fits(convention_entry(*meaning).type, parameter.type)) return std::nullopt;
  if (is_tangent(*meaning) && is_used(root, position)) return std::nullopt;
  return *meaning;
}

/// With what it is made of; at most three levels deep.
ir::ValueId add_convention(ir::Graph& graph, Convention id) {
  std::vector<ir::ValueId> operands;
  for (Convention operand : convention_entry(id).operands) operands.push_back(add_convention(graph, operand));
  return graph.convention(id, operands);
}

}  // namespace

std::optional<std::vector<RootArgument>> root_arguments(const Snapshot::State& state, const CheckedDefinition& root) {
  if (has_brdf_parameters(root.signature)) return std::nullopt;
  std::vector<RootArgument> arguments;
  for (uint32_t i = 0; i < root.parameters.size(); ++i) {
    const std::optional<RootArgument> argument = argument_of(state, root, i);
    if (!argument) return std::nullopt;
    arguments.push_back(*argument);
  }
  return arguments;
}

ir::LinkableDefinition call_of_root(const Snapshot::State& state, const LocatedDefinition& root,
                                    const std::vector<RootArgument>& arguments) {
  const ParsedBlock& block = root.at.parsed();
  const CheckedDefinition& checked = root.checked();
  ir::LinkableDefinition call;
  call.id = NameId{state.names->size()};  // no definition of the document has it
  call.name = read_name(block, root.syntax().name);
  call.canonical = canonical_form(call.name);
  call.signature = {.is_function = false, .parameters = {}, .result = checked.signature.result};
  call.equation = one_line(block, root.syntax().left);

  std::vector<ir::ValueId> values;
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (const auto* convention = std::get_if<Convention>(&arguments[i])) {
      values.push_back(add_convention(call.graph, *convention));
    } else {
      const NameId name = std::get<NameId>(arguments[i]);
      const Type type = state.locate(*state.find(name)).checked().signature.result;
      values.push_back(call.graph.leaf(ir::Op::Reference, type, name.value));
    }
  }
  call.graph.roots = {call.graph.leaf(ir::Op::Call, checked.signature.result, root.name().value, values)};
  return call;
}

}  // namespace texbrdf
