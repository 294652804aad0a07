#include "features/expression.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "ir/lower.h"
#include "ir/written_out.h"

namespace texbrdf::features {
namespace {

std::optional<uint32_t> token_at(const ParsedBlock& block, uint32_t offset) {
  const auto behind = std::ranges::upper_bound(block.tokens, offset, {}, [](const Token& t) { return t.span.begin; });
  if (behind == block.tokens.begin()) return std::nullopt;
  const auto token = std::prev(behind);
  if (offset >= token->span.end) return std::nullopt;
  return static_cast<uint32_t>(token - block.tokens.begin());
}

bool holds(const Node& node, uint32_t token) {
  return token >= node.first_token && token < node.end_token;
}

NodeId innermost(const SyntaxTree& tree, NodeId node, uint32_t token) {
  const auto holds_token = [&](NodeId child) { return holds(tree.node(child), token); };
  while (true) {
    const std::span<const NodeId> children = tree.children(node);
    const auto inner = std::ranges::find_if(children, holds_token);
    if (inner == children.end()) return node;
    node = *inner;
  }
}

bool is_compound(NodeKind kind) {
  switch (kind) {
    case NodeKind::Group:
    case NodeKind::Tuple:
    case NodeKind::Matrix:
    case NodeKind::Bars:
    case NodeKind::Angles:
    case NodeKind::Prefix:
    case NodeKind::Infix:
    case NodeKind::Fraction:
    case NodeKind::Root:
    case NodeKind::Function:
    case NodeKind::Degrees:
    case NodeKind::Inverse:
    case NodeKind::Extremum:
    case NodeKind::BigOperator:
    case NodeKind::Integral:
    case NodeKind::Derivative:
    case NodeKind::Apply:
    case NodeKind::VectorLiteral:
    case NodeKind::Cases:
    case NodeKind::Comparison:
    case NodeKind::Membership:
    case NodeKind::Junction:
    case NodeKind::Not:
    case NodeKind::Juxtaposition:
      return true;
    case NodeKind::Number:
    case NodeKind::Name:
    case NodeKind::Range:
    case NodeKind::Set:
    case NodeKind::Domain:
    case NodeKind::Differential:
    case NodeKind::Case:
    case NodeKind::MatrixRow:
    case NodeKind::Error:
    case NodeKind::Signature:
    case NodeKind::Definition:
      return false;
  }
  return false;
}

bool has_formals(const ir::Graph& graph) {
  return std::ranges::any_of(graph.values(), [](const ir::Value& value) { return value.op == ir::Op::Formal; });
}

/// No name in it is bound by a sum, integral or derivative around it.
bool stands_alone(const ParsedBlock& block, const DefinitionSyntax& syntax, const CheckedDefinition& checked,
                  NodeId expression) {
  const auto is_inside = [&](uint32_t bound) {
    const NodeId binder = checked.bound[bound].node;
    return binder <= expression && holds(block.tree.node(expression), block.tree.node(binder).first_token);
  };
  for (uint32_t node = syntax.first_node; node <= expression.value; ++node) {
    if (!holds(block.tree.node(expression), block.tree.node(NodeId{node}).first_token)) continue;
    const Referent& referent = checked.referents[node - syntax.first_node];
    switch (referent.kind) {
      case Referent::Kind::Bound:
        if (!is_inside(referent.index)) return false;
        break;
      case Referent::Kind::BoundAngle:
        if (!is_inside(angle_of_parameter(referent).position)) return false;
        break;
      case Referent::Kind::Indexed:
        if (!std::ranges::all_of(checked.indexed[referent.index].bound, is_inside)) return false;
        break;
      case Referent::Kind::None:
      case Referent::Kind::Definition:
      case Referent::Kind::Convention:
      case Referent::Kind::Parameter:
      case Referent::Kind::Angle:
      case Referent::Kind::Builtin:
      case Referent::Kind::Derived:
      case Referent::Kind::Derivative:
      case Referent::Kind::Transposition:
        break;
    }
  }
  return true;
}

/// As if the expression were the whole right side of its definition.
std::optional<ir::LinkableDefinition> as_definition(const Snapshot& snapshot, const Expression& expression) {
  const Definition definition = snapshot.definition(expression.definition);
  if (!definition.checked->sound || type_of(snapshot, expression) == Type::Boolean) return std::nullopt;
  DefinitionSyntax part = snapshot.syntax(expression.definition);
  if (!stands_alone(snapshot.parsed(definition.block), part, *definition.checked, expression.node)) return std::nullopt;
  part.body = expression.node;

  ir::LinkableDefinition linkable;
  linkable.id = definition.name;
  linkable.canonical = snapshot.names().text(definition.name);
  linkable.graph = ir::lower_definition(snapshot.parsed(definition.block), part, snapshot.names_of(definition.block),
                                        *definition.checked);
  if (has_formals(linkable.graph)) linkable.signature = definition.checked->signature;
  linkable.formals.resize(linkable.signature.parameters.size());  // nobody reads what they are called
  linkable.signature.result = type_of(snapshot, expression);
  return has_brdf_parameters(linkable.signature) ? std::optional(std::move(linkable)) : std::nullopt;
}

}  // namespace

std::optional<Expression> expression_at(const Snapshot& snapshot, uint32_t offset) {
  const std::optional<BlockId> id = snapshot.block_at(offset);
  if (!id) return std::nullopt;
  const Block block = snapshot.block(*id);
  const ParsedBlock& parsed = *block.parsed;
  const std::optional<uint32_t> relative = parsed.from_source(offset - block.offset);
  const std::optional<uint32_t> token = relative ? token_at(parsed, *relative) : std::nullopt;
  if (!token) return std::nullopt;
  const DefinitionRange range = snapshot.definitions_of(*id);
  for (uint32_t i = 0; i < parsed.definitions.size(); ++i) {
    const NodeId body = parsed.definitions[i].body;
    if (!parsed.definitions[i].readable) continue;
    if (!holds(parsed.tree.node(body), *token)) continue;
    const NodeId node = innermost(parsed.tree, body, *token);
    if (!is_compound(parsed.tree.node(node).kind)) return std::nullopt;
    return Expression{{range.first.value + i}, node};
  }
  return std::nullopt;
}

Type type_of(const Snapshot& snapshot, const Expression& expression) {
  const uint32_t first = snapshot.syntax(expression.definition).first_node;
  return snapshot.definition(expression.definition).checked->types[expression.node.value - first];
}

std::optional<ir::Program> program_of(const Snapshot& snapshot, const Expression& expression, uint32_t most_values) {
  const std::optional<ir::LinkableDefinition> root = as_definition(snapshot, expression);
  if (!root) return std::nullopt;
  uint32_t values = 0;
  const auto lookup = [&](const Instance& use) -> const ir::LinkableDefinition* {
    const ir::LinkableDefinition* found = use.function == root->id ? &*root : snapshot.linkable(use);
    if (found != nullptr) values += found->graph.size();
    return values > most_values ? nullptr : found;
  };
  Result<ir::Program> program = ir::link(lookup, root->id, {});
  if (!program || ir::written_out(*program, most_values) > most_values) return std::nullopt;
  return *std::move(program);
}

}  // namespace texbrdf::features
