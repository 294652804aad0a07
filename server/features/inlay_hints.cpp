#include "features/inlay_hints.h"

#include <fmt/format.h>

#include <algorithm>

#include "features/places.h"
#include "features/value_text.h"

namespace texbrdf::features {
namespace {

bool is_number(const ParsedBlock& block, NodeId node) {
  if (block.tree.node(node).kind == NodeKind::Prefix) node = block.tree.child(node, 0);
  return block.tree.node(node).kind == NodeKind::Number;
}

/// A literal says its value itself.
bool is_literal(const ParsedBlock& block, NodeId node) {
  switch (block.tree.node(node).kind) {
    case NodeKind::Number:
    case NodeKind::VectorLiteral:
      return true;
    case NodeKind::Prefix:
      return is_number(block, node);
    case NodeKind::Tuple:
      return std::ranges::all_of(block.tree.children(node), [&](NodeId child) { return is_number(block, child); });
    case NodeKind::Name:
    case NodeKind::Group:
    case NodeKind::Matrix:
    case NodeKind::MatrixRow:
    case NodeKind::Bars:
    case NodeKind::Angles:
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
    case NodeKind::Range:
    case NodeKind::Set:
    case NodeKind::Domain:
    case NodeKind::Differential:
    case NodeKind::Apply:
    case NodeKind::Cases:
    case NodeKind::Case:
    case NodeKind::Comparison:
    case NodeKind::Membership:
    case NodeKind::Junction:
    case NodeKind::Not:
    case NodeKind::Juxtaposition:
    case NodeKind::Error:
    case NodeKind::Signature:
    case NodeKind::Definition:
      return false;
  }
  return false;
}

class HintWriter {
 public:
  HintWriter(const Snapshot& snapshot, Span range, const InlayHintOptions& options)
      : snapshot_(snapshot), range_(range), options_(options) {}

  void add_definition(DefinitionId id) {
    const Definition& definition = snapshot_.definition(id);
    const DefinitionSyntax& syntax = snapshot_.syntax(id);
    if (options_.parameter_types) {
      for (const CheckedParameter& parameter : definition.checked->parameters) {
        if (parameter.inferred) add_type(node_span(snapshot_, definition.block, parameter.node).end, parameter.type);
      }
    }
    if (options_.definition_types) {
      add_type(node_span(snapshot_, definition.block, syntax.left).end, definition.checked->signature.result);
    }
    if (options_.constant_values && !is_literal(snapshot_.parsed(definition.block), syntax.body)) {
      add_value(node_span(snapshot_, definition.block, syntax.body).end, id);
    }
  }

  std::vector<InlayHint> take() { return std::move(hints_); }

 private:
  void add_type(uint32_t offset, Type type) {
    if (type == Type::Error || !range_.touches(offset)) return;
    hints_.push_back({offset, InlayHint::Kind::Type, fmt::format(": {}", type_symbol(type))});
  }
  void add_value(uint32_t offset, DefinitionId id) {
    if (!range_.touches(offset)) return;
    const auto value = snapshot_.constant_value(id);
    if (value) hints_.push_back({offset, InlayHint::Kind::Value, fmt::format("= {}", value_text(*value))});
  }

  const Snapshot& snapshot_;
  Span range_;
  InlayHintOptions options_;
  std::vector<InlayHint> hints_;
};

}  // namespace

std::vector<InlayHint> inlay_hints(const Snapshot& snapshot, Span range, const InlayHintOptions& options) {
  HintWriter writer(snapshot, range, options);
  const auto count = static_cast<uint32_t>(snapshot.blocks().size());
  for (uint32_t i = snapshot.block_at(range.begin).value_or(BlockId{}).value; i < count; ++i) {
    if (snapshot.absolute(BlockId{i}, {}).begin > range.end) break;
    const DefinitionRange definitions = snapshot.definitions_of(BlockId{i});
    for (uint32_t id = definitions.first.value; id < definitions.end.value; ++id) writer.add_definition({id});
  }
  return writer.take();
}

}  // namespace texbrdf::features
